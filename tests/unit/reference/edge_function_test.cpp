#include "raster/edge_function.h"

#include <gtest/gtest.h>

#include <random>

namespace havs {
namespace {

using Wide = __int128;

int signOf(Wide value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// The triple product of points with integral coordinates and the pixel (x, y) / unit, times unit^2.
Wide product(const ScreenPoint& a, const ScreenPoint& b, Wide x, Wide y, Wide unit) {
  auto whole = [](double value) { return static_cast<Wide>(value); };
  const Wide ax = whole(a.x) * unit - x * whole(a.w), ay = whole(a.y) * unit - y * whole(a.w);
  const Wide bx = whole(b.x) * unit - x * whole(b.w), by = whole(b.y) * unit - y * whole(b.w);
  return ax * by - ay * bx;
}

// Small numbers, so that rays often meet edges: against 128-bit integers, the move (e, e^2) by e = 2^-20.
TEST(EdgeFunction, AgreesWithIntegersAtAPixelMovedALittle) {
  constexpr int kBits = 20;
  const Wide unit = Wide{1} << (2 * kBits);
  std::mt19937 random(3);
  auto number = [&](int low, int high) {
    return static_cast<double>(std::uniform_int_distribution(low, high)(random));
  };
  int onEdge = 0, withoutSides = 0;
  for (int i = 0; i < 200000; ++i) {
    const ScreenPoint a{number(-4, 4), number(-4, 4), number(-1, 2), 0};
    const ScreenPoint b{number(-4, 4), number(-4, 4), number(-1, 2), 0};
    const double x = number(-2, 2), y = number(-2, 2);
    const EdgeSide side = exactEdgeSide(a, b, x, y);
    const Wide atX = static_cast<Wide>(x) * unit, atY = static_cast<Wide>(y) * unit;
    const Wide exact = product(a, b, atX, atY, unit) / (unit * unit);
    EXPECT_EQ(side.value, static_cast<double>(exact));
    EXPECT_EQ(side.sign, signOf(product(a, b, atX + (Wide{1} << kBits), atY + 1, unit)));
    onEdge += exact == 0;
    withoutSides += side.sign == 0;
  }
  EXPECT_GT(onEdge, 10000);
  EXPECT_GT(withoutSides, 1000);
}

// Points that differ from a line through the pixel in the last bit only.
TEST(EdgeFunction, IsExactWhereDoublesAreNot) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(1, 2);
  int wrongInDouble = 0;
  for (int i = 0; i < 20000; ++i) {
    const double x = 100.5, y = 37.5;
    const double slope = unit(random), run = 3 * unit(random), w = unit(random);
    // a = (x + run, y + slope run), b on the other side at the same slope: products of two roundings.
    const ScreenPoint a{(x + run) * w, (y + slope * run) * w, w, 0};
    const ScreenPoint b{x - 0.5 * run, y - 0.5 * (slope * run), 1, 0};
    using Long = __float128;
    const Long ax = Long(a.x) - Long(x) * Long(a.w), ay = Long(a.y) - Long(y) * Long(a.w);
    const Long bx = Long(b.x) - Long(x), by = Long(b.y) - Long(y);  // all four exact in 113 bits
    const Long exact = ax * by - ay * bx;  // relative rounding 2^-113 of the products, which are multiples of 2^-92
    const EdgeSide side = exactEdgeSide(a, b, x, y);
    EXPECT_EQ(side.value, static_cast<double>(exact));
    const double inDouble = (a.x - x * a.w) * (b.y - y) - (a.y - y * a.w) * (b.x - x);
    wrongInDouble += (inDouble > 0) != (exact > 0);
    if (std::abs(inDouble) > edgeLimit(a, b, 200, 200)) {
      EXPECT_EQ(inDouble > 0, exact > 0);
    }
  }
  EXPECT_GT(wrongInDouble, 1000);  // or the test would show nothing
}

TEST(EdgeFunction, BeyondItsLimitADoubleIsGood) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::size_t beyond = 0;
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const double closeness = std::exp2(-30 * std::abs(unit(random)));  // how near both ends lie to the ray
    const double x = std::floor(256 * (1 + unit(random))) + 0.5, y = std::floor(256 * (1 + unit(random))) + 0.5;
    auto point = [&] {
      const double w = 2 + unit(random);
      return ScreenPoint{(x + 300 * closeness * unit(random)) * w, (y + 300 * closeness * unit(random)) * w, w, 0};
    };
    const ScreenPoint a = point(), b = point();
    const double inDouble = (a.x - x * a.w) * (b.y - y * b.w) - (a.y - y * a.w) * (b.x - x * b.w);
    if (!(std::abs(inDouble) > edgeLimit(a, b, 513, 513))) continue;
    ++beyond;
    worst = std::max(worst, std::abs(inDouble / exactEdgeSide(a, b, x, y).value - 1));
  }
  EXPECT_LE(worst, 0x1p-20);
  EXPECT_GT(beyond, 50000u);
}

}  // namespace
}  // namespace havs
