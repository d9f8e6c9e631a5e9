// The lookup `3d` against the reference: its table read in double at the reference's own segments must give the same
// picture, so that what differs from the truth is the table's.
#include <cmath>

#include "image/against_reference.h"
#include "reference/reference_renderer.h"
#include "render/plan.h"
#include "transfer/pieces.h"
#include "transfer/preintegration.h"

namespace havs::test {
namespace {

/// Trilinear in the table.
Rgba lookUp(const Table3d& table, const CellSegment& segment) {
  const std::array<double, 3> place{segment.scalarEntry, segment.scalarExit,
                                    (segment.exit - segment.entry) / table.maximumLength};
  std::array<std::size_t, 3> first;
  std::array<double, 3> share;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double entry = std::clamp(place[axis], 0.0, 1.0) * (table.size - 1);
    first[axis] = std::min(static_cast<std::size_t>(entry), static_cast<std::size_t>(table.size - 2));
    share[axis] = entry - static_cast<double>(first[axis]);
  }
  std::array<double, 4> sum{};
  const auto size = static_cast<std::size_t>(table.size);
  for (std::size_t corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::array<std::size_t, 3> at = first;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t step = corner >> axis & 1;
      at[axis] += step;
      weight *= step ? share[axis] : 1 - share[axis];
    }
    for (std::size_t c = 0; c < 4; ++c)
      sum[c] += weight * double{table.rgba[4 * ((at[2] * size + at[1]) * size + at[0]) + c]};
  }
  return {sum[0], sum[1], sum[2], sum[3]};
}

Image drawnWithTable(const Pair& pair, int size) {
  const Table3d table = buildTable3d(pair.prepared.curve, size, pair.prepared.longestEdge);
  Image image = pair.truth;
  visitRays(pair.prepared, pair.view, [&](int x, int y, std::span<const CellSegment> segments) {
    Rgba sum(0, 0, 0, 0);
    for (const CellSegment& segment : segments) sum = DoubleArithmetic::compositeUnder(sum, lookUp(table, segment));
    const std::array<double, 4> color{sum.r, sum.g, sum.b, sum.a};
    for (std::size_t c = 0; c < 4; ++c) image.pixel(x, y)[c] = static_cast<float>(color[c]);
  });
  return image;
}

class TableAccuracy : public AgainstReference {};

TEST_P(TableAccuracy, IsThatOfTheTableReadInDouble) {
  Scene scene;
  scene.transferFunction = "viridis";
  scene.lookup = "3d";
  scene.tableSize = 32;
  const Pair& pair = draw(scene);
  const Comparison comparison = compareImages(pair.picture.image, drawnWithTable(pair, tableSizeOf(scene)), pair.mask);
  // Places in the table are rounded to some 2^-24 of its 32 entries, a segment's colour changes by at most 1 from entry
  // to entry, and of the segments that change so much a ray has few: 99.9% of the pixels stay below three of those.
  EXPECT_LE(comparison.rgba.p999, 6e-6);
  EXPECT_GT(pair.comparison.rgba.p999, 1e-4) << "a small table must show, or nothing was tested";
}

/// Trilinear interpolation errs by the square of the step where the integrand is smooth.
TEST_P(TableAccuracy, IsOfSecondOrderInTheStep) {
  Scene scene;
  scene.transferFunction = "viridis";
  scene.lookup = "3d";
  scene.tableSize = 17;
  const double coarse = draw(scene).comparison.rgba.rmse;
  scene.tableSize = 65;  // a quarter of the step
  const double fine = draw(scene).comparison.rgba.rmse;
  EXPECT_NEAR(std::log(coarse / fine) / std::log(4.0), 2, 0.2);
}

INSTANTIATE_TEST_SUITE_P(Meshes, TableAccuracy, testing::ValuesIn(meshesDrawn()), nameOfMesh);

}  // namespace
}  // namespace havs::test
