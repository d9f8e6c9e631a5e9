// Steps of a table's grid by their series, against their pieces one by one.
#include "transfer/grid_pieces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "transfer/preintegration.h"

namespace havs {
namespace {

constexpr int kLines = 17;

/// The composite of the pieces of a step with `added` extinction, by integratePiece.
Rgba piecewise(const ExtinctionCurve& curve, int step, bool ascending, double lengthPerScalar, double added) {
  const double low = static_cast<double>(step) / (kLines - 1), high = static_cast<double>(step + 1) / (kLines - 1);
  Rgba sum(0, 0, 0, 0);
  visitPieces(curve, ascending ? low : high, ascending ? high : low, [&](Rgba front, Rgba back, double extent) {
    front.a += added;
    back.a += added;
    sum = DoubleArithmetic::compositeUnder(sum, integratePiece(front, back, extent * lengthPerScalar));
  });
  return sum;
}

void expectNear(const Rgba& value, const Rgba& expected, double bound) {
  EXPECT_NEAR(value.r, expected.r, bound * expected.r);
  EXPECT_NEAR(value.g, expected.g, bound * expected.g);
  EXPECT_NEAR(value.b, expected.b, bound * expected.b);
  EXPECT_NEAR(value.a, expected.a, bound * expected.a);
}

// Lengths for which a step is anything from next to clear to opaque: all of the series, and what lies beyond it. The
// series alternates: at optical depth 1 its terms add up to less than three times the sum, at most 18 roundings each.
TEST(GridPieces, StepsAreTheirPiecesToTheLastDigits) {
  for (const TransferPreset& preset : transferPresets()) {
    SCOPED_TRACE(preset.name);
    const ExtinctionCurve curve = withoutOpaque(makeCurve(loadTransferFunction(preset.name), {}));
    for (const double added : {0.0, 1e-6}) {
      const GridPieces grid(curve, kLines, added);
      std::vector<Lanes> steps(kLines - 1);
      for (const double length : {1e-12, 1e-6, 0.01, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0}) {
        grid.steps(0, kLines - 1, length, steps.data());
        for (int i = 0; i < kLines - 1; ++i) {
          const auto& c = steps[static_cast<std::size_t>(i)].value;
          expectNear({c[0], c[1], c[2], c[3]}, piecewise(curve, i, true, length, added), 2e-14);
          expectNear({c[4], c[5], c[6], c[7]}, piecewise(curve, i, false, length, added), 2e-14);
          for (std::size_t channel = 0; channel < 3; ++channel) {
            EXPECT_LE(c[channel], c[3]);
            EXPECT_LE(c[4 + channel], c[7]);
          }
        }
      }
    }
  }
}

TEST(GridPieces, AStepDoesNotDependOnOthers) {
  TransferFunction function = loadTransferFunction("rainbow");
  const ExtinctionCurve before = makeCurve(function, {});
  function.points.back().opacity = 1 - function.points.back().opacity / 2;
  const ExtinctionCurve after = makeCurve(function, {});
  const GridPieces one(before, kLines), other(after, kLines);
  for (const double length : {1e-3, 0.3, 5.0}) {
    std::vector<Lanes> a(kLines - 1), b(kLines - 1), part(kLines - 1);
    one.steps(0, kLines - 1, length, a.data());
    other.steps(0, kLines - 1, length, b.data());
    one.steps(2, 5, length, part.data());
    EXPECT_EQ(a[3].value, b[3].value);
    EXPECT_EQ(a[3].value, part[3].value);
    EXPECT_NE(a.back().value, b.back().value);
  }
}

TEST(GridPieces, DepthsAreWithoutWhatIsAdded) {
  const ExtinctionCurve curve = makeCurve(loadTransferFunction("three-peaks"), {});
  const GridPieces grid(curve, kLines, 0.5);
  double sum = 0, expected = 0;
  for (int i = 0; i < kLines - 1; ++i) sum += grid.depthOf(i, 2);
  visitPieces(curve, 0, 1, [&](const Rgba& low, const Rgba& high, double extent) {
    expected += (low.a + high.a) * extent;  // twice the mean, for the length of 2
  });
  EXPECT_NEAR(sum, expected, 1e-13 * expected);
}

}  // namespace
}  // namespace havs
