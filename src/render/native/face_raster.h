#pragma once
// The faces of a tile on SIMD lanes: each is cut into stamps of 4 x 4 pixels, and what it covers of a stamp is handed
// to the drawer, which makes of it what the picture is made of: fragments for a k-buffer (tile_kernel.h), or
// scalars that come in any order (gather_kernel.h).
//
// Which pixels a face covers is exact: where the edge functions in float come too near to zero for their sign to be
// sure, the exact rule (raster/face_hit.h) decides.
#include <algorithm>
#include <bit>
#include <type_traits>

#include "raster/face_hit.h"
#include "render/native/face_batch.h"
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

/// A drawer derives from it and has
///   void prepareFace(int i)        face i of the batch, whose edges are known: sets batch_.value, or way to nothing
///   void drawCovered(int i, int stamp, int group, unsigned covered, const function&)
///                                  in the pixels of `covered`, a group of lanes of a stamp; function(n): the face's
///                                  n-th function at these pixels
///   void drawHit(int i, int stamp, int pixel, const FaceHit& hit)   the same of one pixel, in double
template <class Lanes, class Batch, class Drawer>
class FaceRaster {
 protected:
  using Real = typename Lanes::Real;
  using Mask = typename Lanes::Mask;
  static constexpr int kLanes = static_cast<int>(Lanes::kLanes);
  static constexpr int kGroups = kStampPixels / kLanes;  ///< a stamp is drawn in so many groups of lanes
  static constexpr unsigned kGroupBits = kAllLanes >> (kStampPixels - kLanes);

 private:
  /// One number of each of a face's functions.
  using OfFunctions = std::conditional_t<Batch::kFunctions <= 8, EightNumbers, SixteenNumbers>;

  /// A group of a stamp with pixels that the face covers, or may cover.
  struct Touched {
    OfFunctions offset;  ///< from the functions in the face's first stamp to those here
    int stamp, group;
    unsigned sure, unsure;
  };
  static constexpr int kMostListed = 32;  ///< before they are drawn; and those of another row of stamps

 protected:
  explicit FaceRaster(TileDraw& tile) : tile_(tile) {}

  void drawFaces() {
    for (std::size_t i = 0; i < tile_.faceCount && tile_.activePixels > 0; i += kBatch) {
      fetchAhead(i);
      drawBatch(tile_.faces + i, static_cast<int>(std::min<std::size_t>(kBatch, tile_.faceCount - i)));
    }
  }

  int stamps() const { return tile_.stampsAcross * tile_.stampsDown; }
  static unsigned groupBits(unsigned stampBits, int group) { return stampBits >> (group * kLanes) & kGroupBits; }
  static Real clamped(Real value, float low = 0, float high = 1) {
    return Lanes::least(Lanes::most(value, Real(low)), Real(high));
  }
  static double meanOf(const FaceHit& hit, double a, double b, double c) {
    return (hit.a * a + hit.b * b + hit.c * c) / (hit.a + hit.b + hit.c);
  }

  TileDraw& tile_;
  Batch batch_{};

 private:
  Drawer& drawer() { return static_cast<Drawer&>(*this); }

  /// Faces and their corners lie anywhere in memory: faces are fetched two batches ahead, corners one.
  /// Inlined early: g++ takes a function that only prefetches to do nothing, and leaves the call out.
  [[gnu::always_inline]] void fetchAhead(std::size_t i) const {
    for (std::size_t f = i + 2 * kBatch; f < std::min(i + 3 * kBatch, tile_.faceCount); ++f) {
      const std::uint32_t face = tile_.faces[f] & ~kBoundaryBit;
      __builtin_prefetch(tile_.mesh.faces[face]);
    }
    for (std::size_t f = i + kBatch; f < std::min(i + 2 * kBatch, tile_.faceCount); ++f) {
      const std::uint32_t face = tile_.faces[f] & ~kBoundaryBit;
      for (const std::uint32_t corner : tile_.mesh.faces[face]) __builtin_prefetch(tile_.mesh.points + corner);
    }
  }

  void drawBatch(const std::uint32_t* faces, int count) {
    batch_.gather(tile_, faces, count);
    batch_.findBoxes(tile_);
    batch_.findEdges();
    for (int i = 0; i < count; ++i)
      if (batch_.way[i] == FaceWay::stamps) drawer().prepareFace(i);
    batch_.findFunctions();
    for (int i = 0; i < count; ++i) {
      if (batch_.way[i] == FaceWay::stamps) drawStamps(i);
      if (batch_.way[i] == FaceWay::pixelByPixel) drawPixelByPixel(i);
    }
  }

  // ------------------------------------------------------------------------------------------ by stamps
  void drawStamps(int face) {
    const Batch& f = batch_;
    const int firstColumn = f.left[face] / kStampSide, lastColumn = f.right[face] / kStampSide;
    const int firstRow = f.top[face] / kStampSide, lastRow = f.bottom[face] / kStampSide;
    OfFunctions perX{}, perY{};
    const int functions = Batch::kValues > kFewValues ? Batch::kNumerator + f.values : Batch::kFunctions;
    for (int i = 0; i < functions; ++i) {
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
    tile_.fragments += static_cast<unsigned>(std::popcount(covered));
    drawer().drawCovered(face, t.stamp, t.group, covered,
                         [&](int i) { return inFirst_[i][t.group] + Real(t.offset[i]); });
  }

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
    for (int y = batch_.top[i]; y <= batch_.bottom[i]; ++y) {
      const int first = batch_.left[i], last = batch_.right[i];
      for (int sense = 1; sense >= -1; sense -= 2) {
        int from = first, to = last;
        if (!spanOf(corners, y, sense, from, to)) continue;
        for (int x = from; x <= to; ++x) drawPixel(i, x, y, sense);
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

  void drawPixel(int i, int x, int y, int sense) {
    const FaceCorners& corners = batch_.corners[i];
    const int stamp = y / kStampSide * tile_.stampsAcross + x / kStampSide;
    const int pixel = y % kStampSide * kStampSide + x % kStampSide;
    if ((tile_.active[stamp] >> pixel & 1) == 0) return;
    const FaceHit hit = hitAt(corners, x, y);
    if (hit.sign != sense) return;
    const RasterPoint* const* p = corners.p;
    if (!(meanOf(hit, p[0]->w, p[1]->w, p[2]->w) > 0)) return;                       // behind the eye
    if (!std::isfinite(meanOf(hit, p[0]->depth, p[1]->depth, p[2]->depth))) return;  // the eye in the face's plane
    ++tile_.fragments;
    drawer().drawHit(i, stamp, pixel, hit);
  }

  Real inFirst_[Batch::kFunctions][kGroups];  ///< a face's functions at the pixels of its first stamp
  Touched touched_[kMostListed + kLargestTileStamps * kGroups + 1];
};

}  // namespace
}  // namespace havs
