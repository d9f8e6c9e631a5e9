#pragma once
// The k-buffer of a tile on SIMD lanes. Faces come near first (face_raster.h); a stamp's fragments go through the
// arithmetic of shaders/core/kbuffer.glsl, and what leaves as visible segments goes into a queue, full lanes of which
// are coloured later; compositing keeps the order of each pixel.
#include "render/native/face_raster.h"
#include "render/native/fragment_light.h"
#include "render/native/pixel_buffers.h"
#include "render/native/queue_segments.h"

namespace havs {
namespace {

/// Numbers that are interpolated across a face besides the depth.
template <class Payload>
inline constexpr int kAttributesOf = Payload::kNumbers;
template <class Lanes>
inline constexpr int kAttributesOf<LitPayload<Lanes>> = 1 + kMostRowNumbers;

template <class Lanes, class Pixels>
class TileDrawer
    : public FaceRaster<Lanes, FaceBatch<1 + kAttributesOf<typename Pixels::A::Payload>>, TileDrawer<Lanes, Pixels>> {
  using A = typename Pixels::A;
  using Payload = typename A::Payload;
  static constexpr int kAttributes = kAttributesOf<Payload>;
  static constexpr bool kLit = std::is_same_v<Payload, LitPayload<Lanes>>;
  static constexpr bool kColors = std::is_same_v<Payload, ColorPayload<Lanes>>;
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
  explicit TileDrawer(TileDraw& tile) : Raster(tile) {
    if constexpr (kLit) batch_.values = 2 + tile.light->rowLength;
  }

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
    if (bits != 0) queueSegment<Lanes>(tile_, segment, bits, firstPixel);
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
  /// Of the numbers that are interpolated, so many are used.
  int attributes() const { return kLit ? batch_.values - 1 : kAttributes; }

  void prepareFace(int i) {
    for (int j = 0; j < 3; ++j) batch_.value[0][j][i] = batch_.depth[j][i];
    for (int a = 0; a < attributes(); ++a) {
      double value[3];
      attributesOf(batch_.corners[i], batch_.face[i], batch_.entersMesh[i], a, value);
      for (int j = 0; j < 3; ++j) batch_.value[1 + a][j][i] = value[j];
      if (a > 0) continue;
      const Bounds bounds = boundsOf(value);
      batch_.low[i] = bounds.low;
      batch_.high[i] = bounds.high;
    }
  }

  /// Of the first attribute, the scalar: with isosurfaces those of the corners, so that a ray in a region of one value
  /// does not waver about a surface of that value.
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
      if constexpr (kColors) {
        const std::size_t at = mesh.cellData ? 2 * std::size_t{face} + (entersMesh ? 0 : 1) : corners.index[i];
        value[i] = static_cast<double>(mesh.colors[at][a]);
      } else if (a == 0) {
        value[i] = mesh.cellData ? static_cast<double>(mesh.behind[face][entersMesh ? 0 : 1]) : corners.p[i]->scalar;
      } else if constexpr (kLit) {
        const TileLight& light = *tile_.light;
        value[i] = static_cast<double>(light.rows[std::size_t{corners.index[i]} * light.rowLength + (a - 1)]);
      }
    }
  }

  template <class Function>
  void drawCovered(int face, int stamp, int group, unsigned covered, const Function& function) {
    const Batch& f = batch_;
    const Real perSum = Real(1.0f) / function(Batch::kSum);
    auto value = [&](int i) { return Real(f.value0[i][face]) + function(Batch::kNumerator + i) * perSum; };
    insert(stamp, group, covered, fragmentOf(stamp, group, Real(f.kind[face]), {f.low[face], f.high[face]}, value));
  }

  void drawHit(int i, int stamp, int pixel, const FaceHit& hit) {
    const FaceCorners& corners = batch_.corners[i];
    const bool entersMesh = (hit.sign < 0) != corners.reversed;
    auto value = [&](int v) {
      double at[3];
      if (v == 0) {
        for (int j = 0; j < 3; ++j) at[j] = corners.p[j]->depth;
      } else {
        attributesOf(corners, batch_.face[i], entersMesh, v - 1, at);
      }
      return Real(static_cast<float>(meanOf(hit, at[0], at[1], at[2])));
    };
    const Real kind = Real(batch_.boundary[i] ? (entersMesh ? 1.0f : -1.0f) : 0.0f);
    const int group = pixel / kLanes, lane = pixel % kLanes;
    double scalar[3];
    attributesOf(corners, batch_.face[i], entersMesh, 0, scalar);
    insert(stamp, group, 1u << lane, fragmentOf(stamp, group, kind, boundsOf(scalar), value));
  }

  /// value(0): the depth; value(1 + a): attribute a.
  template <class Value>
  typename A::Fragment fragmentOf(int stamp, int group, Real kind, const Bounds& bounds, const Value& value) const {
    const Real depth = value(0), scale = Lanes::load(tile_.rayScale + stamp * kStampPixels + group * kLanes);
    typename A::Fragment fragment;
    fragment.distance = depth * scale;
    fragment.payload.kind = kind;
    if constexpr (kLit) {
      fragment.payload.scalar = clamped(value(1), bounds.low, bounds.high);
      Real row[kMostRowNumbers];
      for (int i = 0; i < tile_.light->rowLength; ++i) row[i] = value(2 + i);
      auto number = [&](int i) { return row[i]; };
      const FragmentLight<A, Lanes> light{*tile_.light};
      const int left = tile_.left + stamp % tile_.stampsAcross * kStampSide;
      const int top = tile_.top + stamp / tile_.stampsAcross * kStampSide;
      const Real x = Real(static_cast<float>(left)) + Lanes::load(kLaneX + group * kLanes);
      const Real y = Real(static_cast<float>(top)) + Lanes::load(kLaneY + group * kLanes);
      fragment.payload.light = light.at(x, y, depth, Real(1.0f) / scale, number);
      fragment.payload.density = light.densityAt(number);
    } else {
      fragment.payload.number(0) = clamped(value(1), bounds.low, bounds.high);
      for (int i = 1; i < kAttributes; ++i) fragment.payload.number(i) = clamped(value(1 + i));
    }
    return fragment;
  }
};

template <class Lanes, class Pixels>
void drawTileKernel(TileDraw& tile) {
  TileDrawer<Lanes, Pixels>(tile).draw();
}

}  // namespace
}  // namespace havs
