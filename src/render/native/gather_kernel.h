#pragma once
// Pictures whose parts come in any order: no order of the faces, no k-buffer. Of every cell, the segments of the rays
// that cross it (cell_batch.h); or, where only the greatest or least scalar counts, the fragments of its faces.
#include <bit>

#include "render/native/cell_batch.h"
#include "render/native/face_raster.h"
#include "render/native/queue_segments.h"

namespace havs {
namespace {

/// The segments of all cells, into the queue.
template <class Lanes>
class SegmentGatherer {
  using Real = typename Lanes::Real;
  using Mask = typename Lanes::Mask;
  static constexpr int kLanes = static_cast<int>(Lanes::kLanes);
  static constexpr int kGroups = kStampPixels / kLanes;
  static constexpr unsigned kGroupBits = kAllLanes >> (kStampPixels - kLanes);
  using B = CellBatch;

  struct Segment {
    Real scalarFront, scalarBack, length;
  };
  struct Stretch {
    Real entry, exit;
  };
  /// A group of a stamp with pixels whose rays cross the cell.
  struct Touched {
    Stretch stretch;
    float x, y;  ///< of the stamp, relative to the block
    int stamp, group;
    unsigned bits;
  };

 public:
  explicit SegmentGatherer(TileDraw& tile) : tile_(tile) {}

  void draw() {
    for (std::size_t i = 0; i < tile_.faceCount; i += kBatch) {
      fetchAhead(i);
      const int count = static_cast<int>(std::min<std::size_t>(kBatch, tile_.faceCount - i));
      batch_.gather(tile_, tile_.faces + i, count);
      batch_.prepare(tile_);
      for (int c = 0; c < count; ++c)
        if (batch_.drawn[c]) drawCell(c);
    }
    tile_.flush(tile_);
  }

 private:
  [[gnu::always_inline]] void fetchAhead(std::size_t i) const {
    for (std::size_t c = i + 2 * kBatch; c < std::min(i + 3 * kBatch, tile_.faceCount); ++c)
      __builtin_prefetch(tile_.mesh.cells[tile_.faces[c]]);
    for (std::size_t c = i + kBatch; c < std::min(i + 2 * kBatch, tile_.faceCount); ++c)
      for (const std::uint32_t corner : tile_.mesh.cells[tile_.faces[c]])
        __builtin_prefetch(tile_.mesh.points + corner);
  }

  void drawCell(int c) {
    for (int f = 0; f < B::kFunctions; ++f) {
      perX_[f] = Real(batch_.perX[f][c]);
      perY_[f] = Real(batch_.perY[f][c]);
      for (int group = 0; group < kGroups; ++group)
        inFirst_[f][group] =
            (perX_[f] * Lanes::load(kLaneX + group * kLanes) + perY_[f] * Lanes::load(kLaneY + group * kLanes)) +
            Real(batch_.atOrigin[f][c]);
    }
    const int firstColumn = batch_.left[c] / kStampSide, lastColumn = batch_.right[c] / kStampSide;
    const int firstRow = batch_.top[c] / kStampSide, lastRow = batch_.bottom[c] / kStampSide;
    const int left = tile_.left - blockOf(tile_.left), top = tile_.top - blockOf(tile_.top);
    int listed = 0;
    for (int row = firstRow; row <= lastRow; ++row) {
      const float y = static_cast<float>(top + row * kStampSide);
      for (int group = 0; group < kGroups; ++group) {
        Real inRow[B::kScalar];
        for (int f = 0; f < B::kScalar; ++f) inRow[f] = perY_[f] * Real(y) + inFirst_[f][group];
        for (int column = firstColumn; column <= lastColumn; ++column) {
          const int stamp = row * tile_.stampsAcross + column;
          const float x = static_cast<float>(left + column * kStampSide);
          auto t = [&](int f) { return perX_[f] * Real(x) + inRow[f]; };
          const Real entry = Lanes::most(Lanes::most(t(B::kFront), t(B::kFront + 1)),
                                         Lanes::most(t(B::kFront + 2), Real(batch_.nearest[c])));
          const Real exit = Lanes::least(Lanes::least(t(B::kBack), t(B::kBack + 1)),
                                         Lanes::least(t(B::kBack + 2), Real(batch_.farthest[c])));
          const unsigned bits = tile_.active[stamp] >> (group * kLanes) & kGroupBits & Lanes::bitsOf(exit > entry);
          // Number by number: a whole put together beside it would be copied before its parts have arrived there.
          Touched& next = touched_[listed];
          next.stretch.entry = entry;
          next.stretch.exit = exit;
          next.x = x;
          next.y = y;
          next.stamp = stamp;
          next.group = group;
          next.bits = bits;
          listed += bits != 0 ? 1 : 0;  // without a branch, which would often be guessed wrong
        }
      }
      if (listed > kMostListed || row == lastRow) {
        for (int i = 0; i < listed; ++i) drawTouched(c, touched_[i]);
        listed = 0;
      }
    }
  }

  /// u = w0 t / (1 - t), for parallel rays t.
  void drawTouched(int c, const Touched& touched) {
    const auto& [entry, exit] = touched.stretch;
    auto function = [&](int f) {
      return perX_[f] * Real(touched.x) + (perY_[f] * Real(touched.y) + inFirst_[f][touched.group]);
    };
    const Real bend = Real(tile_.mesh.parallelRays ? 0.0f : 1.0f);
    const Real toEntry = Real(1.0f) - bend * entry, toExit = Real(1.0f) - bend * exit;
    const Real scale = Real(static_cast<float>(tile_.mesh.fixedDistance)) / (toEntry * toExit);
    const Real scalar = function(B::kScalar), rate = function(B::kRate);
    auto clamped = [&](Real s) {
      return Lanes::least(Lanes::most(s, Real(batch_.leastScalar[c])), Real(batch_.mostScalar[c]));
    };
    const int firstPixel = touched.stamp * kStampPixels + touched.group * kLanes;
    Segment segment;
    segment.scalarFront = clamped(scalar + rate * (entry * toExit * scale));
    segment.scalarBack = clamped(scalar + rate * (exit * toEntry * scale));
    segment.length = (exit - entry) * scale * Lanes::load(tile_.rayScale + firstPixel);
    tile_.fragments += static_cast<unsigned>(std::popcount(touched.bits));
    queueSegment<Lanes>(tile_, segment, touched.bits, firstPixel);
  }

  static constexpr int kMostListed = 32;  ///< before they are drawn; and those of another row of stamps
  TileDraw& tile_;
  CellBatch batch_{};
  Real perX_[B::kFunctions], perY_[B::kFunctions];
  Real inFirst_[B::kFunctions][kGroups];  ///< a cell's functions at the pixels of the block's first stamp
  Touched touched_[kMostListed + kLargestTileStamps * kGroups + 1];
};

/// The greatest or the least scalar of all fragments, kept in TileDraw::state, into the first number of each pixel.
template <class Lanes, bool kGreatest>
class ExtremeGatherer : public FaceRaster<Lanes, FaceBatch<1>, ExtremeGatherer<Lanes, kGreatest>> {
  using Batch = FaceBatch<1>;
  using Raster = FaceRaster<Lanes, Batch, ExtremeGatherer>;
  friend Raster;
  using Raster::batch_;
  using Raster::clamped;
  using Raster::kLanes;
  using Raster::meanOf;
  using Raster::stamps;
  using Raster::tile_;
  using typename Raster::Real;

 public:
  explicit ExtremeGatherer(TileDraw& tile) : Raster(tile) {}

  void draw() {
    const int pixels = stamps() * kStampPixels;
    for (int i = 0; i < pixels; ++i) tile_.state[i] = tile_.rgba[4 * i];
    this->drawFaces();
    for (int i = 0; i < pixels; ++i) tile_.rgba[4 * i] = tile_.state[i];
  }

 private:
  /// Cell data: rays that leave the mesh meet no cell behind the face.
  bool showsNothing(int i, bool entersMesh) const { return tile_.mesh.cellData && batch_.boundary[i] && !entersMesh; }
  double scalarAt(int i, bool entersMesh, int corner) const {
    if (!tile_.mesh.cellData) return batch_.corners[i].p[corner]->scalar;
    return static_cast<double>(tile_.mesh.behind[batch_.face[i]][entersMesh ? 0 : 1]);
  }

  void prepareFace(int i) {
    if (showsNothing(i, batch_.entersMesh[i])) {
      batch_.way[i] = FaceWay::nothing;
      return;
    }
    for (int j = 0; j < 3; ++j) batch_.value[0][j][i] = scalarAt(i, batch_.entersMesh[i], j);
  }

  template <class Function>
  void drawCovered(int i, int stamp, int group, unsigned covered, const Function& function) {
    const Real perSum = Real(1.0f) / function(Batch::kSum);
    take(stamp, group, covered, clamped(Real(batch_.value0[0][i]) + function(Batch::kNumerator) * perSum));
  }

  void drawHit(int i, int stamp, int pixel, const FaceHit& hit) {
    const bool entersMesh = (hit.sign < 0) != batch_.corners[i].reversed;
    if (showsNothing(i, entersMesh)) return;
    const double scalar =
        meanOf(hit, scalarAt(i, entersMesh, 0), scalarAt(i, entersMesh, 1), scalarAt(i, entersMesh, 2));
    take(stamp, pixel / kLanes, 1u << pixel % kLanes, clamped(Real(static_cast<float>(scalar))));
  }

  void take(int stamp, int group, unsigned bits, Real scalar) {
    float* const at = tile_.state + stamp * kStampPixels + group * kLanes;
    const Real kept = Lanes::load(at);
    const Real better = kGreatest ? Lanes::most(kept, scalar) : Lanes::least(kept, scalar);
    Lanes::store(at, Lanes::select(Lanes::maskOf(bits), better, kept));
  }
};

template <class Gatherer>
void gatherTile(TileDraw& tile) {
  Gatherer(tile).draw();
}

}  // namespace
}  // namespace havs
