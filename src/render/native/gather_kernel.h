#pragma once
// Pictures whose parts come in any order: faces as they lie in memory, no k-buffer. A face that rays enter a cell
// through gives the cell's segment, whose end is found from the cell alone (shaders/core/cell_exit.glsl); where only
// the greatest or least scalar counts, its fragment is enough.
#include "core/arithmetic.h"
#include "render/native/face_raster.h"
#include "render/native/queue_segments.h"

namespace havs {
namespace {

/// The segments of all cells, into the queue.
template <class Lanes>
class SegmentGatherer : public FaceRaster<Lanes, FaceBatch<1, 3>, SegmentGatherer<Lanes>> {
  using A = Arithmetic<Lanes>;
  using Batch = FaceBatch<1, 3>;
  using Raster = FaceRaster<Lanes, Batch, SegmentGatherer>;
  friend Raster;
  using Raster::batch_;
  using Raster::clamped;
  using Raster::kLanes;
  using Raster::meanOf;
  using Raster::tile_;
  using typename Raster::Real;

  /// The cell that rays enter through a face.
  struct CellBehind {
    const RasterPoint* corner = nullptr;  ///< not on the face; null: there is none
    double scalar[4];                     ///< at the face's corners, and at that one
  };
  /// How the weights of the face's corners change along the ray of the pixel (x, y) of the picture, per unit of depth:
  /// rate[j][0] + (x - x0) rate[j][1] + (y - y0) rate[j][2].
  struct Rates {
    double rate[3][3];
  };
  using Segment = typename A::Segment;

 public:
  explicit SegmentGatherer(TileDraw& tile) : Raster(tile) {}

  void draw() {
    this->drawFaces();
    tile_.flush(tile_);
  }

 private:
  CellBehind cellBehind(const FaceCorners& corners, std::uint32_t face, bool entersFirst) const {
    const RasterMesh& mesh = tile_.mesh;
    const int side = entersFirst ? 0 : 1;
    const std::uint32_t opposite = mesh.opposite[face][side];
    CellBehind cell;
    if (opposite == kNoCorner) return cell;
    cell.corner = mesh.points + opposite;
    for (int j = 0; j < 3; ++j)
      cell.scalar[j] = mesh.cellData ? static_cast<double>(mesh.behind[face][side]) : corners.p[j]->scalar;
    cell.scalar[3] = mesh.cellData ? cell.scalar[0] : cell.corner->scalar;
    return cell;
  }

  struct Range {
    double least, most;
  };
  static Range rangeOf(const CellBehind& cell) {
    Range range{cell.scalar[0], cell.scalar[0]};
    for (int j = 1; j < 4; ++j) {
      range.least = cell.scalar[j] < range.least ? cell.scalar[j] : range.least;
      range.most = cell.scalar[j] > range.most ? cell.scalar[j] : range.most;
    }
    return range;
  }

  /// With d the corner behind, a weight's gradient is the cross product of the other two corners' places relative to d,
  /// over the cell's volume; the ray goes along (x - x0, y - y0, 1) from the eye, or along depth. All rates are 0 for a
  /// flat cell.
  Rates ratesOf(const FaceCorners& corners, const RasterPoint& d, double x0, double y0) const {
    double e[3][3];
    for (int j = 0; j < 3; ++j) {
      const RasterPoint& p = *corners.p[j];
      e[j][0] = (p.x - x0 * p.w) - (d.x - x0 * d.w);
      e[j][1] = (p.y - y0 * p.w) - (d.y - y0 * d.w);
      e[j][2] = p.depth - d.depth;
    }
    double gradient[3][3];
    for (int j = 0; j < 3; ++j)
      for (int c = 0; c < 3; ++c) {
        const double *b = e[(j + 1) % 3], *f = e[(j + 2) % 3];
        gradient[j][c] = b[(c + 1) % 3] * f[(c + 2) % 3] - b[(c + 2) % 3] * f[(c + 1) % 3];
      }
    const double volume = e[0][0] * gradient[0][0] + e[0][1] * gradient[0][1] + e[0][2] * gradient[0][2];
    const double scale = volume != 0 ? 1 / volume : 0;
    const double across = tile_.mesh.parallelRays ? 0 : scale;
    Rates rates;
    for (int j = 0; j < 3; ++j) {
      rates.rate[j][0] = gradient[j][2] * scale;
      rates.rate[j][1] = gradient[j][0] * across;
      rates.rate[j][2] = gradient[j][1] * across;
    }
    return rates;
  }

  void prepareFace(int i) {
    const FaceCorners& corners = batch_.corners[i];
    const CellBehind cell = cellBehind(corners, batch_.face[i], batch_.entersMesh[i]);
    if (cell.corner == nullptr) {
      batch_.way[i] = FaceWay::nothing;  // rays leave the mesh
      return;
    }
    rates_[i] = ratesOf(corners, *cell.corner, batch_.originX[i] + 0.5, batch_.originY[i] + 0.5);
    for (int j = 0; j < 3; ++j) {
      batch_.value[0][j][i] = cell.scalar[j];
      drop_[j][i] = static_cast<float>(cell.scalar[j] - cell.scalar[3]);
      weightScale_[j][i] = static_cast<float>(batch_.error[j][i]);
    }
    const Range range = rangeOf(cell);
    least_[i] = static_cast<float>(range.least);
    most_[i] = static_cast<float>(range.most);
  }

  void prepareFunctions() {
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < kBatch; ++i) {
        const double* rate = rates_[i].rate[j];
        batch_.put(Batch::kFirstOwn + j, i, rate[0], rate[1], rate[2], 1);
      }
  }

  template <class Function>
  void drawCovered(int i, int stamp, int group, unsigned covered, const Function& function) {
    const Real perSum = Real(1.0f) / function(Batch::kSum);
    auto weight = [&](int j) { return clamped(function(j) * Real(weightScale_[j][i]) * perSum); };
    const Real rateA = function(Batch::kFirstOwn), rateB = function(Batch::kFirstOwn + 1),
               rateC = function(Batch::kFirstOwn + 2);
    const Real rate = Real(drop_[0][i]) * rateA + Real(drop_[1][i]) * rateB + Real(drop_[2][i]) * rateC;
    const Real front = clamped(Real(batch_.value0[0][i]) + function(Batch::kNumerator) * perSum);
    const typename A::CellStretch stretch = A::stretchOf(weight(0), weight(1), weight(2), rateA, rateB, rateC, front,
                                                         rate, Real(least_[i]), Real(most_[i]));
    queue(stamp, group, covered, front, stretch);
  }

  /// Rates are those of the sense that the pixel sees the face in.
  void drawHit(int i, int stamp, int pixel, const FaceHit& hit) {
    const FaceCorners& corners = batch_.corners[i];
    const CellBehind cell = cellBehind(corners, batch_.face[i], (hit.sign < 0) != corners.reversed);
    if (cell.corner == nullptr) return;
    const double x = tile_.left + stamp % tile_.stampsAcross * kStampSide + pixel % kStampSide + 0.5;
    const double y = tile_.top + stamp / tile_.stampsAcross * kStampSide + pixel / kStampSide + 0.5;
    const Rates rates = ratesOf(corners, *cell.corner, x, y);
    double rate = 0;
    for (int j = 0; j < 3; ++j) rate += rates.rate[j][0] * (cell.scalar[j] - cell.scalar[3]);
    const auto real = [](double value) { return Real(static_cast<float>(value)); };
    const auto weight = [&](double of) { return clamped(real(of / (hit.a + hit.b + hit.c))); };
    const Real front = clamped(real(meanOf(hit, cell.scalar[0], cell.scalar[1], cell.scalar[2])));
    const Range range = rangeOf(cell);
    const typename A::CellStretch stretch =
        A::stretchOf(weight(hit.a), weight(hit.b), weight(hit.c), real(rates.rate[0][0]), real(rates.rate[1][0]),
                     real(rates.rate[2][0]), front, real(rate), real(range.least), real(range.most));
    queue(stamp, pixel / kLanes, 1u << pixel % kLanes, front, stretch);
  }

  void queue(int stamp, int group, unsigned bits, Real front, const typename A::CellStretch& stretch) {
    Segment segment;
    segment.scalarFront = front;
    segment.scalarBack = stretch.scalar;
    segment.length = stretch.length * Lanes::load(tile_.rayScale + stamp * kStampPixels + group * kLanes);
    bits &= Lanes::bitsOf(segment.length > Real(0.0f));
    if (bits != 0) queueSegment<Lanes, 1>(tile_, segment, bits, stamp * kStampPixels + group * kLanes);
  }

  Rates rates_[kBatch]{};
  float drop_[3][kBatch];         ///< from a corner's scalar to that behind
  float weightScale_[3][kBatch];  ///< edge functions are kept as multiples of their error
  float least_[kBatch], most_[kBatch];
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
  void prepareFunctions() {}

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
