// The orders of accuracy of the lookups (docs/02-method.md, Orders): fitted slopes against what theory says, on a
// transfer function that is smooth down to steps far below every segment.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "support/slope.h"
#include "unit/transfer/lookup_functions.h"

namespace havs::test {
namespace {

constexpr double kTolerance = 0.2;
constexpr int kGrid = 512;                // scalars of segments lie on its lines, where a table needs no interpolation
constexpr double kLengthPerScalar = 0.8;  // along every ray
constexpr double kLengthOfTable = 0.8;    // the theory is for segments much shorter than that

/// Smooth colours and extinction, in linear pieces that are short against all segments.
ExtinctionCurve smoothCurve(int knots = 4 * kGrid) {
  ExtinctionCurve curve;
  for (int i = 0; i <= knots; ++i) {
    const double s = static_cast<double>(i) / knots;
    curve.knots.push_back({s,
                           {0.5 + 0.5 * std::sin(7 * s), 0.5 + 0.4 * std::cos(9 * s), 0.6 + 0.3 * std::sin(4 * s + 1)},
                           4 + 3 * std::sin(8 * s + 0.5)});
  }
  return curve;
}

/// Root mean square, over both directions and all places, of the error of one segment of `steps` steps of the grid.
double segmentError(const ExtinctionCurve& curve, const LookupFunction& lookup, int steps) {
  double squares = 0;
  int count = 0;
  const double length = kLengthPerScalar * steps / kGrid;
  for (int low = 0; low + steps <= kGrid; low += 19)
    for (bool rises : {true, false}) {
      const double a = static_cast<double>(low) / kGrid, b = static_cast<double>(low + steps) / kGrid;
      const double front = rises ? a : b, back = rises ? b : a;
      squares += std::pow(distance(lookup(front, back, length), exactly(curve, front, back, length)), 2);
      ++count;
    }
  return std::sqrt(squares / count);
}

/// The same of a ray from one end of the scalar to the other in segments of `steps` steps, composited.
double rayError(const ExtinctionCurve& curve, const LookupFunction& lookup, int steps) {
  double worst = 0;
  for (bool rises : {true, false}) {
    Rgba sum(0, 0, 0, 0);
    for (int i = 0; i < kGrid; i += steps) {
      const double a = static_cast<double>(i) / kGrid, b = static_cast<double>(i + steps) / kGrid;
      sum = DoubleArithmetic::compositeUnder(
          sum, rises ? lookup(a, b, kLengthPerScalar * (b - a)) : lookup(1 - a, 1 - b, kLengthPerScalar * (b - a)));
    }
    worst = std::max(worst, distance(sum, exactly(curve, rises ? 0 : 1, rises ? 1 : 0, kLengthPerScalar)));
  }
  return worst;
}

struct Expected {
  std::string name;
  LookupFunction lookup;
  double perSegment;
  double perRay;
};

std::vector<Expected> lookupsWithOrders(const ExtinctionCurve& curve) {
  return {{"post", postLookup(curve), 3, 2},
          {"riemann:1", riemannLookup(curve, 1), 3, 2},
          {"riemann:4", riemannLookup(curve, 4), 3, 2},
          {"riemann-linear:1", riemannLinearLookup(curve, 1), 2, 1},
          {"riemann-linear:4", riemannLinearLookup(curve, 4), 2, 1},
          {"integral", integralLookup(curve), 2, 1},
          {"2d, of one length", table2dLookup(curve, kGrid + 1, kLengthOfTable), 2, 1}};
}

TEST(LookupOrder, InSegmentLength) {
  const ExtinctionCurve curve = smoothCurve();
  for (const Expected& e : lookupsWithOrders(curve)) {
    std::vector<double> lengths, segment, ray;
    for (int steps : {2, 4, 8, 16}) {
      lengths.push_back(steps);
      segment.push_back(segmentError(curve, e.lookup, steps));
      ray.push_back(rayError(curve, e.lookup, steps));
    }
    RecordProperty(e.name,
                   fmt::format("{:.3f} a segment, {:.3f} a ray", slopeOf(lengths, segment), slopeOf(lengths, ray)));
    EXPECT_NEAR(slopeOf(lengths, segment), e.perSegment, kTolerance) << e.name << ", a segment";
    EXPECT_NEAR(slopeOf(lengths, ray), e.perRay, kTolerance) << e.name << ", a ray";
  }
}

// A table made for the segments of the mesh, as `2d` is: its length shrinks with theirs, and one order is won.
TEST(LookupOrder, OfThe2dTableWhoseLengthFollowsTheSegments) {
  const ExtinctionCurve curve = smoothCurve();
  std::vector<double> lengths, segment, ray;
  for (int steps : {4, 8, 16, 32}) {
    // The segments are half as long as the table is meant for.
    const LookupFunction lookup = table2dLookup(curve, kGrid + 1, 2 * kLengthPerScalar * steps / kGrid);
    lengths.push_back(steps);
    segment.push_back(segmentError(curve, lookup, steps));
    ray.push_back(rayError(curve, lookup, steps));
  }
  EXPECT_NEAR(slopeOf(lengths, segment), 3, kTolerance);
  EXPECT_NEAR(slopeOf(lengths, ray), 2, kTolerance);
}

TEST(LookupOrder, InSamplesOfASegment) {
  const ExtinctionCurve curve = smoothCurve();
  std::vector<double> samples, corrected, linear;
  for (int n : {4, 8, 16, 32}) {
    samples.push_back(n);
    corrected.push_back(segmentError(curve, riemannLookup(curve, n), kGrid / 4));
    linear.push_back(segmentError(curve, riemannLinearLookup(curve, n), kGrid / 4));
  }
  EXPECT_NEAR(slopeOf(samples, corrected), -2, kTolerance);
  EXPECT_NEAR(slopeOf(samples, linear), -1, kTolerance);
}

// In the entries along each axis, at random places and lengths.
TEST(LookupOrder, InTableSize) {
  const ExtinctionCurve curve = smoothCurve(kGrid);
  struct Table {
    std::string name;
    std::function<LookupFunction(int size)> make;
  };
  constexpr double kLongest = 0.5;
  const std::vector<Table> tables{{"3d", [&](int size) { return table3dLookup(curve, size, kLongest); }},
                                  {"3d-normalised", [&](int size) { return normalisedLookup(curve, size, kLongest); }}};
  for (const Table& table : tables) {
    std::vector<double> sizes, errors;
    for (int size : {9, 17, 33, 65}) {
      const LookupFunction lookup = table.make(size);
      double squares = 0;
      std::uint32_t state = 1;
      const auto next = [&] { return (state = state * 1664525U + 1013904223U) / 4294967296.0; };
      for (int i = 0; i < 1000; ++i) {
        const double front = next(), back = next(), length = kLongest * next();
        squares += std::pow(distance(lookup(front, back, length), exactly(curve, front, back, length)), 2);
      }
      sizes.push_back(size - 1);
      errors.push_back(std::sqrt(squares / 1000));
    }
    RecordProperty(table.name, fmt::format("{:.3f}", slopeOf(sizes, errors)));
    EXPECT_NEAR(slopeOf(sizes, errors), -2, kTolerance) << table.name;
  }
}

}  // namespace
}  // namespace havs::test
