// exp and expm1 of the shared arithmetic against the C library's long double.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/arithmetic.h"

namespace havs {
namespace {

template <class Lane>
class Exponential : public testing::Test {
 protected:
  using A = Arithmetic<Lane>;
  using Real = typename Lane::Real;
  // One rounding for 1 + p or scale * p, one for the sum, and what the argument's reduction leaves.
  static constexpr long double kBound = 2 * std::numeric_limits<Real>::epsilon();

  /// Calls check(x) for x <= 0: 200,000 magnitudes, evenly in the logarithm, from 1e-20 to 80.
  template <class Check>
  static void forNegative(const Check& check) {
    for (int i = 0; i <= 200000; ++i) check(static_cast<Real>(-80.0 * std::pow(10.0, -22.0 * i / 200000)));
  }
};

using Lanes = testing::Types<FloatLane, DoubleLane>;
TYPED_TEST_SUITE(Exponential, Lanes);

TYPED_TEST(Exponential, ExpIsWithinTwoUlps) {
  long double worst = 0;
  this->forNegative([&](auto x) {
    const long double exact = std::exp(static_cast<long double>(x));
    worst = std::max(worst, std::fabs(TestFixture::A::expOfNegative(x) / exact - 1));
  });
  EXPECT_LE(worst, this->kBound);
}

TYPED_TEST(Exponential, Expm1IsWithinTwoUlps) {
  long double worst = 0;
  this->forNegative([&](auto x) {
    const long double exact = std::expm1(static_cast<long double>(x));
    worst = std::max(worst, std::fabs(TestFixture::A::expm1OfNegative(x) / exact - 1));
  });
  EXPECT_LE(worst, this->kBound);
}

TYPED_TEST(Exponential, EndsAreExact) {
  using Own = Arithmetic<TypeParam>;
  using Number = typename TypeParam::Real;
  EXPECT_EQ(Own::expOfNegative(Number(0)), Number(1));
  EXPECT_EQ(Own::expm1OfNegative(Number(0)), Number(0));
  EXPECT_EQ(Own::expOfNegative(Number(-1e4)), Number(0));
  EXPECT_EQ(Own::expm1OfNegative(Number(-1e4)), Number(-1));
}

}  // namespace
}  // namespace havs
