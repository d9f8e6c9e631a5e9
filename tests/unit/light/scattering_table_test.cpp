#include "light/scattering_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/error.h"
#include "core/parallel.h"
#include "light/henyey_greenstein.h"
#include "unit/gauss_kronrod.h"

namespace havs::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kBeyond = kScatteringOrders + 1;

TEST(HenyeyGreenstein, IsADensityWhoseMeanCosineIsG) {
  for (const double g : {0.0, 1e-12, -1e-5, 0.3, -0.6, 0.9, 0.99}) {
    const auto sphere = [&](const auto& f) {
      return static_cast<double>(integrate(
          [&](long double cosine) { return 2 * kPi * henyeyGreenstein(g, static_cast<double>(cosine)) * f(cosine); },
          -1, 1, 14));
    };
    EXPECT_NEAR(sphere([](long double) { return 1; }), 1, 1e-13);
    EXPECT_NEAR(sphere([](long double cosine) { return 1 + cosine; }), 1 + g, 1e-13);
    for (const double cosine : {-1.0, -0.999999, -0.5, 0.0, 0.3, 0.999, 1.0}) {
      const double share = henyeyGreensteinShare(g, cosine);
      if (cosine > -1) {
        const double expected = static_cast<double>(integrate(
            [&](long double c) { return 2 * kPi * henyeyGreenstein(g, static_cast<double>(c)); }, -1, cosine, 14));
        EXPECT_NEAR(share, expected, 1e-13 * expected);
      }
      // The share of the last digit of 1 is worth this much of the cosine.
      EXPECT_NEAR(henyeyGreensteinCosine(g, share), cosine, 1e-15 / (2 * kPi * henyeyGreenstein(g, cosine)) + 1e-15);
    }
  }
}

const ScatteringTable& tableOf(double g) {
  static std::vector<std::pair<double, ScatteringTable>> tables;
  for (const auto& [known, table] : tables)
    if (known == g) return table;
  tables.reserve(16);
  return tables.emplace_back(g, ScatteringTable({g, 8192, 1})).second;
}

/// Of f(cosine) over the sphere between two angles, by the midpoint rule.
template <class F>
double overRing(double from, double to, const F& f) {
  constexpr int kSteps = 100;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = from + (to - from) * (i + 0.5) / kSteps;
    sum += f(std::cos(angle)) * 2 * kPi * std::sin(angle) * (to - from) / kSteps;
  }
  return sum;
}

TEST(ScatteringTable, FirstOrderIsThePhaseFunctionFaded) {
  for (const double tau : {0.0, 0.2, 3.0, 20.0})
    for (const double cosine : {-1.0, 0.2, 1.0})
      EXPECT_EQ(tableOf(0.5).density(1, tau, cosine), henyeyGreenstein(0.5, cosine) * std::exp(-tau));
}

TEST(ScatteringTable, AllOrdersIntegrateToOne) {
  for (const double g : {-0.4, 0.0, 0.5, 0.9})
    for (const double tau : {0.0, 0.01, 0.77, 3.0, 11.3, 40.0}) {
      double sum = 0;
      for (int ring = 0; ring < 10; ++ring)
        sum += overRing(ring * kPi / 10, (ring + 1) * kPi / 10, [&](double c) { return tableOf(g).sum(1, tau, c); });
      EXPECT_NEAR(sum, 1, 1e-4) << g << ' ' << tau;  // the midpoint rule where the table has corners
    }
}

TEST(ScatteringTable, ASmallBallScattersOnce) {
  for (const double g : {0.0, 0.8})
    for (const double tau : {1e-4, 1e-3, 1e-2})
      for (const double cosine : {-0.7, 0.1, 0.6}) {
        const double once = henyeyGreenstein(g, cosine);
        // The share of light that is scattered again is below tau; from the peak it reaches these angles at most with
        // the density there.
        EXPECT_NEAR(tableOf(g).sum(1, tau, cosine), once, tau * henyeyGreenstein(g, 1)) << g << ' ' << tau;
        EXPECT_NEAR(tableOf(g).sum(0.5, tau, cosine), 0.5 * once, tau * henyeyGreenstein(g, 1));
      }
}

/// The definition, walked through without any of the table's ways: one random walk after another, by textbook formulas.
class Walker {
 public:
  Walker(double tau, double g) : tau_(tau), g_(g) {}
  struct Exit {
    int order;
    double cosine;
  };
  Exit walk() {
    std::array<double, 3> x{0, 0, 0}, d = turned({0, 0, 1});
    for (int order = 1;; ++order) {
      const double step = -std::log(1 - unit_(random_));
      double squared = 0;
      for (int i = 0; i < 3; ++i) squared += (x[i] + step * d[i]) * (x[i] + step * d[i]);
      if (squared > tau_ * tau_) return {order, d[2]};
      for (int i = 0; i < 3; ++i) x[i] += step * d[i];
      d = turned(d);
    }
  }

 private:
  /// By rejection: a direction of the sphere is kept with a probability in proportion to the phase function.
  std::array<double, 3> turned(const std::array<double, 3>& d) {
    for (;;) {
      std::array<double, 3> e;
      double squared = 0;
      do {
        squared = 0;
        for (double& v : e) {
          v = 2 * unit_(random_) - 1;
          squared += v * v;
        }
      } while (squared > 1 || squared < 1e-6);
      for (double& v : e) v /= std::sqrt(squared);
      const double cosine = d[0] * e[0] + d[1] * e[1] + d[2] * e[2];
      const double density = std::pow((1 - std::abs(g_)) * (1 - std::abs(g_)) / (1 + g_ * g_ - 2 * g_ * cosine), 1.5);
      if (unit_(random_) < density) return e;
    }
  }
  double tau_, g_;
  std::mt19937_64 random_{12345};
  std::uniform_real_distribution<double> unit_{0, 1};
};

constexpr int kRings = 12;
constexpr int kApart = 6;  // orders compared one by one

/// Counts by order (the last: all higher) and ring of exit angle.
struct Counts {
  std::array<std::array<double, kRings>, kApart + 1> of{};
  std::array<double, kRings> faded{}, fadedSquares{};  ///< sums of albedo^n
};
Counts count(double tau, double g, double albedo, int walks) {
  Counts counts;
  Walker walker(tau, g);
  for (int i = 0; i < walks; ++i) {
    const auto [order, cosine] = walker.walk();
    const auto ring =
        static_cast<std::size_t>(std::min(kRings - 1, static_cast<int>(std::acos(cosine) / kPi * kRings)));
    counts.of[static_cast<std::size_t>(std::min(order, kApart + 1) - 1)][ring] += 1.0 / walks;
    const double light = std::pow(albedo, order);
    counts.faded[ring] += light / walks;
    counts.fadedSquares[ring] += light * light / walks;
  }
  return counts;
}

/// Largest difference in standard errors of both, over rings and orders.
double worstDeviation(double tau, double g, double albedo, int walks) {
  const ScatteringTable& table = tableOf(g);
  const Counts counts = count(tau, g, albedo, walks);
  double worst = 0;
  for (std::size_t ring = 0; ring < kRings; ++ring) {
    const double from = kPi * static_cast<double>(ring) / kRings, to = from + kPi / kRings;
    const auto compare = [&](double counted, double variance, double expected, double tableError) {
      // A walk at least, so that empty rings have an error too.
      const double error = std::hypot(std::sqrt((variance + 1.0 / walks) / walks), tableError);
      worst = std::max(worst, std::abs(counted - expected) / error);
    };
    double fadedError = 0;
    for (std::size_t i = 0; i <= kApart; ++i) {
      double expected = 0, error = 0;
      const std::size_t last = i < kApart ? i + 1 : kBeyond;
      for (std::size_t order = i + 1; order <= last; ++order) {
        expected += overRing(from, to, [&](double c) { return table.density(order, tau, c); });
        error += overRing(from, to, [&](double c) { return table.error(order, tau, c); });
      }
      fadedError += error;
      compare(counts.of[i][ring], counts.of[i][ring], expected, error);
    }
    compare(counts.faded[ring], counts.fadedSquares[ring],
            overRing(from, to, [&](double c) { return table.sum(albedo, tau, c); }), fadedError);
  }
  return worst;
}

// Some 100 numbers of each case against their errors: 4.5 of them are passed once in 150,000 times by chance. Radii of
// the table and others.
TEST(ScatteringTable, AgreesWithWalksOfTheDefinition) {
  for (const double g : {-0.4, 0.0, 0.5, 0.8})
    for (const double tau : {ScatteringTable::radius(10), 1.5, ScatteringTable::radius(24)})
      EXPECT_LE(worstDeviation(tau, g, 0.9, 100000), 4.5) << g << ' ' << tau;
  EXPECT_LE(worstDeviation(9.7, 0.0, 0.99, 20000), 4.5);  // most of it beyond the orders kept apart
}

TEST(ScatteringTable, OfAnyNumberOfThreads) {
  std::vector<double> found[2];
  for (const std::size_t threads : {1, 2}) {
    const ThreadLimit limit(threads);
    const ScatteringTable table({0.6, 512, 7});
    for (std::size_t order = 1; order <= kBeyond; ++order)
      for (const double tau : {0.01, 0.9, 7.0})
        for (const double cosine : {-1.0, 0.4, 1.0}) {
          found[threads - 1].push_back(table.density(order, tau, cosine));
          found[threads - 1].push_back(table.error(order, tau, cosine));
        }
  }
  EXPECT_EQ(found[0], found[1]);
}

TEST(ScatteredLight, IsTheSumOfTheTable) {
  for (const double g : {-0.4, 0.0, 0.5, 0.9})
    for (const double albedo : {0.0, 0.5, 1.0}) {
      const ScatteredLight light(tableOf(g), albedo);
      double worst = 0;
      for (double tau = 0; tau < 20; tau += 0.37)
        for (double angle = 0; angle <= kPi; angle += 0.013) {
          const double sum = tableOf(g).sum(albedo, tau, std::cos(angle));
          worst = std::max(worst, std::abs(light(tau, std::cos(angle)) - sum) / (sum + 1e-3));
        }
      // It cuts the corners of the table, which are noise: of some percent, in this table of few walks.
      EXPECT_LE(worst, 1e-2) << g << ' ' << albedo;
    }
}

TEST(ScatteringTable, RefusesWhatItCannotDo) {
  EXPECT_THROW(ScatteringTable({1.0, 512, 1}), Error);
  EXPECT_THROW(ScatteringTable({NAN, 512, 1}), Error);
  EXPECT_THROW(ScatteringTable({0, 3, 1}), Error);
  EXPECT_THROW(ScatteredLight(tableOf(0), 1.1), Error);
}

}  // namespace
}  // namespace havs::test
