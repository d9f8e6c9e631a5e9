#pragma once
// The k-buffer of a tile on SIMD lanes. Faces come near first (face_raster.h); a stamp's fragments go through the
// arithmetic of shaders/core/kbuffer.glsl, and what leaves as visible segments goes into a queue, full lanes of which
// are coloured later; compositing keeps the order of each pixel.
#include "render/native/face_raster.h"
#include "render/native/pixel_buffers.h"
#include "render/native/queue_segments.h"

namespace havs {
namespace {

template <class Lanes, class Pixels, int kAttributes>
class TileDrawer : public FaceRaster<Lanes, FaceBatch<1 + kAttributes>, TileDrawer<Lanes, Pixels, kAttributes>> {
  using A = typename Pixels::A;
  using Batch = FaceBatch<1 + kAttributes>;
  using Raster = FaceRaster<Lanes, Batch, TileDrawer>;
  friend Raster;
  using Raster::batch_;
  using Raster::clamped;
  using Raster::groupBits;
  using Raster::kGroups;
  using Raster::kLanes;
  using Raster::meanOf;
  using Raster::stamps;
  using Raster::tile_;
  using typename Raster::Mask;
  using typename Raster::Real;

 public:
  explicit TileDrawer(TileDraw& tile) : Raster(tile) {}

  void draw() {
    begin();
    this->drawFaces();
    finish();
  }

 private:
  Pixels pixelsOf(int stamp, int group) const {
    return Pixels(tile_.state + static_cast<std::size_t>(stamp) * Pixels::kNumbers * kStampPixels + group * kLanes);
  }

  void begin() {
    for (int stamp = 0; stamp < stamps(); ++stamp) {
      if (tile_.active[stamp] == 0) continue;
      for (int group = 0; group < kGroups; ++group) pixelsOf(stamp, group).begin();
    }
  }

  // ------------------------------------------------------------------------------------------ segments
  /// The visible ones of `bits`.
  void takeSegment(const typename A::Segment& segment, unsigned bits, int firstPixel) {
    bits &= Lanes::bitsOf(segment.visible);
    if (bits != 0) queueSegment<Lanes, kAttributes>(tile_, segment, bits, firstPixel);
  }

  /// One fragment in each of the pixels of `bits`, a group of lanes of a stamp.
  void insert(int stamp, int group, unsigned bits, const typename A::Fragment& incoming) {
    const auto done = pixelsOf(stamp, group).insert(incoming, bits, tile_);
    if (done.wrong != 0) {
      if constexpr (Pixels::kFlagsWrong) {
        giveUp(stamp, done.wrong << (group * kLanes));
      } else {
        countLate(stamp, group, done.wrong);
      }
    }
    if (done.taken != 0) takeSegment(done.segment, done.taken, stamp * kStampPixels + group * kLanes);
  }

  void giveUp(int stamp, unsigned bits) {
    tile_.flagged[stamp] = static_cast<std::uint16_t>(tile_.flagged[stamp] | bits);
    if (tile_.late != nullptr) return;  // a certificate: all its fragments are counted in this pass
    tile_.active[stamp] = static_cast<std::uint16_t>(tile_.active[stamp] & ~bits);
    tile_.activePixels -= static_cast<std::size_t>(std::popcount(bits));
  }

  void countLate(int stamp, int group, unsigned bits) {
    tile_.lateFragments += static_cast<unsigned>(std::popcount(bits));
    if (tile_.late == nullptr) return;
    std::uint32_t* late = tile_.late + stamp * kStampPixels + group * kLanes;
    for (; bits != 0; bits &= bits - 1) ++late[std::countr_zero(bits)];
  }

  /// What is left in the k-buffers leaves in order.
  void finish() {
    for (int stamp = 0; stamp < stamps(); ++stamp)
      for (int group = 0; group < kGroups; ++group) {
        const unsigned bits = groupBits(tile_.active[stamp], group);
        if (bits == 0) continue;
        pixelsOf(stamp, group).finish([&](const typename A::Segment& segment) {
          takeSegment(segment, bits, stamp * kStampPixels + group * kLanes);
        });
      }
    tile_.flush(tile_);
  }

  // ------------------------------------------------------------------------------------------ fragments
  void prepareFace(int i) {
    for (int j = 0; j < 3; ++j) batch_.value[0][j][i] = batch_.depth[j][i];
    for (int a = 0; a < kAttributes; ++a) {
      double value[3];
      attributesOf(batch_.corners[i], batch_.face[i], batch_.entersMesh[i], a, value);
      for (int j = 0; j < 3; ++j) batch_.value[1 + a][j][i] = value[j];
      if constexpr (kAttributes == 1) {
        const Bounds bounds = boundsOf(value);
        batch_.low[i] = bounds.low;
        batch_.high[i] = bounds.high;
      }
    }
  }

  /// Of the scalar: with isosurfaces those of the corners, so that a ray in a region of one value does not waver about
  /// a surface of that value.
  struct Bounds {
    float low = 0, high = 1;
  };
  Bounds boundsOf(const double* value) const {
    if (!tile_.mesh.isosurfaces) return {};
    const double low = value[0] < value[1] ? value[0] : value[1], high = value[0] < value[1] ? value[1] : value[0];
    return {static_cast<float>(value[2] < low ? value[2] : low), static_cast<float>(value[2] > high ? value[2] : high)};
  }

  /// Attribute `a` at the three corners.
  void attributesOf(const FaceCorners& corners, std::uint32_t face, bool entersMesh, int a, double* value) const {
    const RasterMesh& mesh = tile_.mesh;
    for (int i = 0; i < 3; ++i) {
      if constexpr (kAttributes == 1) {
        value[i] = mesh.cellData ? static_cast<double>(mesh.behind[face][entersMesh ? 0 : 1]) : corners.p[i]->scalar;
      } else {
        const std::size_t at = mesh.cellData ? 2 * std::size_t{face} + (entersMesh ? 0 : 1) : corners.index[i];
        value[i] = static_cast<double>(mesh.colors[at][a]);
      }
    }
  }

  template <class Function>
  void drawCovered(int face, int stamp, int group, unsigned covered, const Function& function) {
    const Batch& f = batch_;
    const Real perSum = Real(1.0f) / function(Batch::kSum);
    const Real scale = Lanes::load(tile_.rayScale + stamp * kStampPixels + group * kLanes);
    auto value = [&](int i) { return Real(f.value0[i][face]) + function(Batch::kNumerator + i) * perSum; };
    typename A::Fragment fragment;
    fragment.distance = value(0) * scale;
    fragment.payload.kind = Real(f.kind[face]);
    if constexpr (kAttributes == 1) {
      fragment.payload.scalar = clamped(value(1), f.low[face], f.high[face]);
    } else {
      for (int i = 0; i < kAttributes; ++i) fragment.payload.color[i] = clamped(value(1 + i));
    }
    insert(stamp, group, covered, fragment);
  }

  void drawHit(int i, int stamp, int pixel, const FaceHit& hit) {
    const FaceCorners& corners = batch_.corners[i];
    const RasterPoint* const* p = corners.p;
    const bool entersMesh = (hit.sign < 0) != corners.reversed;
    const double depth = meanOf(hit, p[0]->depth, p[1]->depth, p[2]->depth);
    const int group = pixel / kLanes, lane = pixel % kLanes;
    const float scale = tile_.rayScale[stamp * kStampPixels + pixel];
    typename A::Fragment fragment;
    fragment.distance = Real(static_cast<float>(depth) * scale);
    fragment.payload.kind = Real(batch_.boundary[i] ? (entersMesh ? 1.0f : -1.0f) : 0.0f);
    for (int a = 0; a < kAttributes; ++a) {
      double value[3];
      attributesOf(corners, batch_.face[i], entersMesh, a, value);
      const Real number(static_cast<float>(meanOf(hit, value[0], value[1], value[2])));
      if constexpr (kAttributes == 1) {
        const Bounds bounds = boundsOf(value);
        fragment.payload.scalar = clamped(number, bounds.low, bounds.high);
      } else {
        fragment.payload.color[a] = clamped(number);
      }
    }
    insert(stamp, group, 1u << lane, fragment);
  }
};

template <class Lanes, class Pixels, int kAttributes>
void drawTileKernel(TileDraw& tile) {
  TileDrawer<Lanes, Pixels, kAttributes>(tile).draw();
}

}  // namespace
}  // namespace havs
