#include "transfer/few_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "transfer/transfer_function.h"

namespace havs {
namespace {

ExtinctionCurve curveOf(const std::vector<std::array<double, 2>>& knots) {
  ExtinctionCurve curve;
  for (const auto& [s, kappa] : knots) curve.knots.push_back({s, {1, 1, 1}, kappa});
  return curve;
}

/// The mean of kappa over [low, high] by the pieces, as shaders/measure/optical_depth_of_few_pieces.glsl has it.
float meanByPieces(const FewPieces& pieces, float low, float high) {
  float from = low, sum = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(pieces.count); ++i) {
    const float to = std::min(std::max(pieces.ends[i], low), high);
    sum += (to - from) * (pieces.atZero[i] + pieces.halfSlope[i] * (from + to));
    from = to;
  }
  return sum / (high - low);
}

/// Of the curve, trapezoid by trapezoid between its knots.
double meanOfCurve(const ExtinctionCurve& curve, double low, double high) {
  double sum = 0;
  for (std::size_t i = 1; i < curve.knots.size(); ++i) {
    const auto &a = curve.knots[i - 1], &b = curve.knots[i];
    const double from = std::max(low, a.s), to = std::min(high, b.s);
    if (!(to > from) || !(b.s > a.s)) continue;
    sum += (to - from) * (a.kappa + (b.kappa - a.kappa) * ((from + to) / 2 - a.s) / (b.s - a.s));
  }
  return sum / (high - low);
}

TEST(FewPieces, StepsTakeNoPieceButAtTheEnd) {
  EXPECT_EQ(countFewPieces(curveOf({{0, 1}, {1, 2}})), 1);
  EXPECT_EQ(countFewPieces(curveOf({{0, 5}, {0, 1}, {0.5, 2}, {0.5, 3}, {1, 1}})), 2);
  EXPECT_EQ(countFewPieces(curveOf({{0, 1}, {1, 2}, {1, 7}})), 2);
}

TEST(FewPieces, ManyOrNarrowOnesAreNotFew) {
  EXPECT_EQ(countFewPieces(curveOf({{0, 1}, {0.5, 2}, {0.51, 3}, {1, 1}})), 0);
  std::vector<std::array<double, 2>> knots;
  for (int i = 0; i <= FewPieces::kMost + 1; ++i) knots.push_back({i / (FewPieces::kMost + 1.0), 1});
  EXPECT_EQ(countFewPieces(curveOf(knots)), 0);
  knots.erase(knots.begin() + 1);
  EXPECT_EQ(countFewPieces(curveOf(knots)), FewPieces::kMost);
  EXPECT_EQ(countFewPieces(makeCurve(loadTransferFunction("viridis"), {})), 0);
}

TEST(FewPieces, MeansAreThoseOfTheCurve) {
  const std::vector<ExtinctionCurve> curves{
      curveOf({{0, 3}, {1, 3}}), curveOf({{0, 0}, {1.0 / 16, 40}, {0.25, 0}, {0.6, 0}, {1, 7}}),
      curveOf({{0, 2}, {0, 1}, {0.3, 4}, {0.3, 0}, {0.55, 0}, {0.55, 9}, {1, 9}, {1, 2}})};
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(0, 1);
  for (const ExtinctionCurve& curve : curves) {
    ASSERT_GT(countFewPieces(curve), 0);
    const FewPieces pieces = fewPieces(curve);
    EXPECT_EQ(pieces.count, countFewPieces(curve));
    double most = 0;  // a piece's line may stand higher than the curve at s = 0: its rounding counts
    for (std::size_t i = 0; i < static_cast<std::size_t>(pieces.count); ++i)
      most = std::max({most, std::abs(static_cast<double>(pieces.atZero[i])), 2.0 * std::abs(pieces.halfSlope[i])});
    for (int i = 0; i < 4000; ++i) {
      const float a = unit(random), b = i % 2 ? unit(random) : a + 0.01f * unit(random);
      const float low = std::min({a, b, 1.0f}), high = std::min(std::max(a, b), 1.0f);
      if (!(high > low)) continue;
      // Of a short segment about an end, the end's rounding to float (2^-25) moves a part of it to the next piece.
      const double rounding =
          8 * 0x1p-24 * most + 40 * 0x1p-25 / (static_cast<double>(high) - static_cast<double>(low));
      EXPECT_NEAR(meanByPieces(pieces, low, high), meanOfCurve(curve, low, high), rounding);
    }
  }
}

TEST(FewPieces, AtTheUpperEndTheLastKnotCounts) {
  const FewPieces pieces = fewPieces(curveOf({{0, 1}, {1, 2}, {1, 7}}));
  EXPECT_FLOAT_EQ(meanByPieces(pieces, 1.0f, 1.0f + 0x1p-23f), 7.0f);
}

}  // namespace
}  // namespace havs
