#pragma once
// The k-buffer of a tile on SIMD lanes. Faces come near first; each is cut into stamps of 4 x 4 pixels. A stamp's
// fragments go through the arithmetic of shaders/core/kbuffer.glsl, and what leaves as visible segments goes into a
// queue, full lanes of which are coloured later; compositing keeps the order of each pixel.
//
// Which pixels a face covers is exact: where the edge functions in float come too near to zero for their sign to be
// sure, the exact rule (raster/face_hit.h) decides.
#include <algorithm>
#include <bit>
#include <type_traits>

#include "raster/face_hit.h"
#include "render/native/face_batch.h"
#include "render/native/pixel_buffers.h"
#include "render/native/simd.h"

namespace havs {
namespace {

constexpr unsigned kAllLanes = 0xFFFFu;
/// Of each lane in its stamp.
alignas(64) constexpr float kLaneX[kStampPixels] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) constexpr std::int32_t kLaneNumber[kStampPixels] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
alignas(64) constexpr float kLaneY[kStampPixels] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

using EightNumbers [[gnu::vector_size(32)]] = float;
using SixteenNumbers [[gnu::vector_size(64)]] = float;

template <class Lanes, class Pixels, int kAttributes>
class TileDrawer {
  using A = typename Pixels::A;
  using Real = typename Lanes::Real;
  using Mask = typename Lanes::Mask;
  using Batch = FaceBatch<kAttributes>;
  static constexpr int kLanes = static_cast<int>(Lanes::kLanes);
  static constexpr int kGroups = kStampPixels / kLanes;  ///< a stamp is drawn in so many groups of lanes
  static constexpr unsigned kGroupBits = kAllLanes >> (kStampPixels - kLanes);

  /// One number of each of a face's functions.
  using OfFunctions = std::conditional_t<Batch::kFunctions <= 8, EightNumbers, SixteenNumbers>;

  /// A group of a stamp with pixels that the face covers, or may cover.
  struct Touched {
    OfFunctions offset;  ///< from the functions in the face's first stamp to those here
    int stamp, group;
    unsigned sure, unsure;
  };
  static constexpr int kMostListed = 32;  ///< before they are drawn; and those of another row of stamps

 public:
  explicit TileDrawer(TileDraw& tile) : tile_(tile), queue_(*tile.queue) {}

  void draw() {
    begin();
    for (std::size_t i = 0; i < tile_.faceCount && tile_.activePixels > 0; i += kBatch) {
      fetchAhead(i);
      drawBatch(tile_.faces + i, static_cast<int>(std::min<std::size_t>(kBatch, tile_.faceCount - i)));
    }
    finish();
  }

 private:
  /// Faces and their corners lie anywhere in memory: faces are fetched two batches ahead, corners one.
  /// Inlined early: g++ takes a function that only prefetches to do nothing, and leaves the call out.
  [[gnu::always_inline]] void fetchAhead(std::size_t i) const {
    for (std::size_t f = i + 2 * kBatch; f < std::min(i + 3 * kBatch, tile_.faceCount); ++f)
      __builtin_prefetch(tile_.mesh.faces[tile_.faces[f] & ~kBoundaryBit]);
    for (std::size_t f = i + kBatch; f < std::min(i + 2 * kBatch, tile_.faceCount); ++f)
      for (const std::uint32_t corner : tile_.mesh.faces[tile_.faces[f] & ~kBoundaryBit])
        __builtin_prefetch(tile_.mesh.points + corner);
  }

  Pixels pixelsOf(int stamp, int group) const {
    return Pixels(tile_.state + static_cast<std::size_t>(stamp) * Pixels::kNumbers * kStampPixels + group * kLanes);
  }
  int stamps() const { return tile_.stampsAcross * tile_.stampsDown; }

  void begin() {
    for (int stamp = 0; stamp < stamps(); ++stamp) {
      if (tile_.active[stamp] == 0) continue;
      for (int group = 0; group < kGroups; ++group) pixelsOf(stamp, group).begin();
    }
  }

  // ------------------------------------------------------------------------------------------ segments
  void queueSegment(const typename A::Segment& segment, Mask mask, unsigned bits, int firstPixel) {
    const std::size_t at = queue_.count;
    if constexpr (kAttributes == 1) {
      Lanes::compress(&queue_.scalarFront[at], segment.scalarFront, mask, bits);
      Lanes::compress(&queue_.scalarBack[at], segment.scalarBack, mask, bits);
    } else {
      for (int i = 0; i < 4; ++i) {
        Lanes::compress(&queue_.front[i][at], segment.front.color[i], mask, bits);
        Lanes::compress(&queue_.back[i][at], segment.back.color[i], mask, bits);
      }
    }
    Lanes::compress(&queue_.length[at], segment.length, mask, bits);
    Lanes::compressInts(&queue_.pixel[at], Lanes::makeInt(firstPixel) + Lanes::loadInts(kLaneNumber), mask, bits);
    queue_.count = at + static_cast<std::size_t>(std::popcount(bits));
    if (queue_.count + kStampPixels > SegmentQueue::kCapacity || tile_.flushAlways) tile_.flush(tile_);
  }

  /// The visible ones of `bits`.
  void takeSegment(const typename A::Segment& segment, unsigned bits, int firstPixel) {
    bits &= Lanes::bitsOf(segment.visible);
    if (bits != 0) queueSegment(segment, Lanes::maskOf(bits), bits, firstPixel);
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

  static unsigned groupBits(unsigned stampBits, int group) { return stampBits >> (group * kLanes) & kGroupBits; }

  // ------------------------------------------------------------------------------------------ faces
  void drawBatch(const std::uint32_t* faces, int count) {
    batch_.gather(tile_, faces, count);
    batch_.findBoxes(tile_);
    batch_.findEdges();
    for (int i = 0; i < count; ++i)
      if (batch_.way[i] == FaceWay::stamps) takeAttributes(i);
    batch_.findFunctions();
    for (int i = 0; i < count; ++i) {
      if (batch_.way[i] == FaceWay::stamps) drawStamps(i);
      if (batch_.way[i] == FaceWay::pixelByPixel) drawPixelByPixel(i);
    }
  }

  void takeAttributes(int i) {
    for (int a = 0; a < kAttributes; ++a) {
      double value[3];
      attributesOf(batch_.corners[i], batch_.face[i], batch_.entersMesh[i], a, value);
      for (int j = 0; j < 3; ++j) batch_.value[1 + a][j][i] = value[j];
    }
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

  // ------------------------------------------------------------------------------------------ by stamps
  void drawStamps(int face) {
    const Batch& f = batch_;
    const int firstColumn = f.left[face] / kStampSide, lastColumn = f.right[face] / kStampSide;
    const int firstRow = f.top[face] / kStampSide, lastRow = f.bottom[face] / kStampSide;
    OfFunctions perX{}, perY{};
    for (int i = 0; i < Batch::kFunctions; ++i) {
      perX[i] = f.perX[i][face];
      perY[i] = f.perY[i][face];
      for (int group = 0; group < kGroups; ++group)
        inFirst_[i][group] = (Real(perX[i]) * Lanes::load(kLaneX + group * kLanes) +
                              Real(perY[i]) * Lanes::load(kLaneY + group * kLanes)) +
                             Real(f.atOrigin[i][face]);
    }
    int listed = 0;
    for (int row = firstRow; row <= lastRow; ++row) {
      const OfFunctions down = perY * static_cast<float>(tile_.top + row * kStampSide - f.originY[face]);
      for (int column = firstColumn; column <= lastColumn; ++column) {
        const int stamp = row * tile_.stampsAcross + column;
        const unsigned active = tile_.active[stamp];
        const OfFunctions offset = perX * static_cast<float>(tile_.left + column * kStampSide - f.originX[face]) + down;
        for (int group = 0; group < kGroups; ++group) {
          auto edge = [&](int i) { return inFirst_[i][group] + Real(offset[i]); };
          const Real inside = Lanes::least(Lanes::least(edge(0), edge(1)), edge(2));
          const unsigned bits = groupBits(active, group);
          const unsigned sure = Lanes::bitsOf(inside > Real(1.0f)) & bits;
          const unsigned unsure = Lanes::bitsOf(inside >= Real(-1.0f)) & bits & ~sure;
          touched_[listed] = {offset, stamp, group, sure, unsure};
          listed += (sure | unsure) != 0 ? 1 : 0;  // without a branch, which would often be guessed wrong
        }
      }
      if (listed > kMostListed || row == lastRow) {
        for (int i = 0; i < listed; ++i) drawTouched(face, touched_[i]);
        listed = 0;
      }
    }
  }

  void drawTouched(int face, const Touched& t) {
    unsigned covered = t.sure;
    if (t.unsure != 0) covered |= decide(batch_.corners[face], t.stamp, t.group, t.unsure);
    if (covered == 0) return;
    const Batch& f = batch_;
    auto function = [&](int i) { return inFirst_[i][t.group] + Real(t.offset[i]); };
    tile_.fragments += static_cast<unsigned>(std::popcount(covered));

    const Real perSum = Real(1.0f) / function(Batch::kSum);
    const Real scale = Lanes::load(tile_.rayScale + t.stamp * kStampPixels + t.group * kLanes);
    typename A::Fragment fragment;
    fragment.distance = (Real(f.value0[0][face]) + function(Batch::kNumerator) * perSum) * scale;
    fragment.payload.kind = Real(f.kind[face]);
    auto attribute = [&](int i) {
      return clamped(Real(f.value0[1 + i][face]) + function(Batch::kNumerator + 1 + i) * perSum);
    };
    if constexpr (kAttributes == 1) {
      fragment.payload.scalar = attribute(0);
    } else {
      for (int i = 0; i < kAttributes; ++i) fragment.payload.color[i] = attribute(i);
    }
    insert(t.stamp, t.group, covered, fragment);
  }

  /// To [0, 1].
  static Real clamped(Real value) { return Lanes::least(Lanes::most(value, Real(0.0f)), Real(1.0f)); }

  /// The pixels of `bits` that the face covers by the exact rule.
  unsigned decide(const FaceCorners& corners, int stamp, int group, unsigned bits) const {
    unsigned covered = 0;
    for (; bits != 0; bits &= bits - 1) {
      const int lane = std::countr_zero(bits);
      const int pixel = group * kLanes + lane;
      const int x = stamp % tile_.stampsAcross * kStampSide + pixel % kStampSide;
      const int y = stamp / tile_.stampsAcross * kStampSide + pixel / kStampSide;
      if (hitAt(corners, x, y).sign != 0) covered |= 1u << lane;
    }
    return covered;
  }

  /// At a pixel of the tile.
  FaceHit hitAt(const FaceCorners& corners, int x, int y) const {
    return hitFace(*corners.p[0], *corners.p[1], *corners.p[2], tile_.left + x + 0.5, tile_.top + y + 0.5,
                   tile_.mesh.width, tile_.mesh.height);
  }

  // ------------------------------------------------------------------------------------------ pixel by pixel
  void drawPixelByPixel(int i) {
    const FaceCorners& corners = batch_.corners[i];
    const bool boundary = batch_.boundary[i];
    const std::uint32_t face = batch_.face[i];
    for (int y = batch_.top[i]; y <= batch_.bottom[i]; ++y) {
      const int first = batch_.left[i], last = batch_.right[i];
      for (int sense = 1; sense >= -1; sense -= 2) {
        int from = first, to = last;
        if (!spanOf(corners, y, sense, from, to)) continue;
        for (int x = from; x <= to; ++x) drawPixel(corners, face, boundary, x, y, sense);
      }
    }
  }

  /// Narrows [from, to] to the pixels of the row where the products may all have the sign of `sense`.
  bool spanOf(const FaceCorners& corners, int row, int sense, int& from, int& to) const {
    const double x0 = tile_.left + 0.5, y = tile_.top + row + 0.5;
    double low = from, high = to;
    for (int i = 0; i < 3; ++i) {
      const RasterPoint &a = *corners.p[(i + 1) % 3], &b = *corners.p[(i + 2) % 3];
      const double ay = a.y - y * a.w, by = b.y - y * b.w;
      const double ax = a.x - x0 * a.w, bx = b.x - x0 * b.w;
      const double at0 = sense * (ax * by - ay * bx), perX = sense * (ay * b.w - a.w * by);
      const double rounding = 64 * 0x1p-53 *
                              ((std::abs(ax) + tile_.mesh.width * std::abs(a.w)) * (std::abs(by) + std::abs(y * b.w)) +
                               (std::abs(bx) + tile_.mesh.width * std::abs(b.w)) * (std::abs(ay) + std::abs(y * a.w)));
      if (perX > 0) {
        low = std::max(low, (-at0 - rounding) / perX - 1e-6);
      } else if (perX < 0) {
        high = std::min(high, (at0 + rounding) / -perX + 1e-6);
      } else if (at0 < -rounding) {
        return false;
      }
    }
    if (!(low <= high)) return false;
    from = static_cast<int>(std::ceil(low));
    to = static_cast<int>(std::floor(high));
    return from <= to;
  }

  void drawPixel(const FaceCorners& corners, std::uint32_t face, bool boundary, int x, int y, int sense) {
    const int stamp = y / kStampSide * tile_.stampsAcross + x / kStampSide;
    const int pixel = y % kStampSide * kStampSide + x % kStampSide;
    if ((tile_.active[stamp] >> pixel & 1) == 0) return;
    const FaceHit hit = hitAt(corners, x, y);
    if (hit.sign != sense) return;
    const RasterPoint* const* p = corners.p;
    const double sum = hit.a + hit.b + hit.c;
    auto mean = [&](double a, double b, double c) { return (hit.a * a + hit.b * b + hit.c * c) / sum; };
    if (!(mean(p[0]->w, p[1]->w, p[2]->w) > 0)) return;  // behind the eye
    const bool entersMesh = (hit.sign < 0) != corners.reversed;
    const double depth = mean(p[0]->depth, p[1]->depth, p[2]->depth);
    if (!std::isfinite(depth)) return;  // the eye in the plane of the face
    ++tile_.fragments;

    const int group = pixel / kLanes, lane = pixel % kLanes;
    const float scale = tile_.rayScale[stamp * kStampPixels + pixel];
    typename A::Fragment fragment;
    fragment.distance = Real(static_cast<float>(depth) * scale);
    fragment.payload.kind = Real(boundary ? (entersMesh ? 1.0f : -1.0f) : 0.0f);
    for (int a = 0; a < kAttributes; ++a) {
      double value[3];
      attributesOf(corners, face, entersMesh, a, value);
      const Real number = clamped(Real(static_cast<float>(mean(value[0], value[1], value[2]))));
      if constexpr (kAttributes == 1) {
        fragment.payload.scalar = number;
      } else {
        fragment.payload.color[a] = number;
      }
    }
    insert(stamp, group, 1u << lane, fragment);
  }

  TileDraw& tile_;
  SegmentQueue& queue_;
  Batch batch_{};
  Real inFirst_[Batch::kFunctions][kGroups];  ///< a face's functions at the pixels of its first stamp
  Touched touched_[kMostListed + kLargestTileStamps * kGroups + 1];
};

template <class Lanes, class Pixels, int kAttributes>
void drawTileKernel(TileDraw& tile) {
  TileDrawer<Lanes, Pixels, kAttributes>(tile).draw();
}

}  // namespace
}  // namespace havs
