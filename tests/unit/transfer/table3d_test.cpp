#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/error.h"
#include "core/parallel.h"
#include "transfer/preintegration.h"
#include "unit/transfer/preset_curve.h"

namespace havs {
namespace {

const float* entry(const Table3d& t, int f, int b, int l) {
  return &t.rgba[((static_cast<std::size_t>(l) * t.size + b) * t.size + f) * 4];
}

/// A smooth hump of extinction, finely knotted, with colour that follows.
ExtinctionCurve smoothCurve() {
  ExtinctionCurve curve;
  constexpr int kKnots = 512;
  for (int i = 0; i <= kKnots; ++i) {
    const double s = static_cast<double>(i) / kKnots;
    curve.knots.push_back({s, {s, 1 - s, 0.5 + 0.5 * std::sin(5 * s)}, 6 * std::exp(-10 * (s - 0.4) * (s - 0.4))});
  }
  return curve;
}

TEST(Table3d, EveryEntryIsTheSegmentRoundedOnce) {
  constexpr int kSize = 20;
  constexpr double kLength = 0.8;
  for (const TransferPreset& preset : transferPresets()) {
    const ExtinctionCurve curve = presetCurve(preset.name);
    const Table3d table = buildTable3d(curve, kSize, kLength);
    for (int l = 0; l < kSize; ++l) {
      for (int b = 0; b < kSize; ++b) {
        for (int f = 0; f < kSize; ++f) {
          const SegmentColor c =
              integrateSegment(curve, f / (kSize - 1.0), b / (kSize - 1.0), kLength * l / (kSize - 1));
          const float* e = entry(table, f, b, l);
          const double exact[4] = {c.color[0], c.color[1], c.color[2], c.alpha};
          for (int i = 0; i < 4; ++i) {
            // Half a unit in the last place of the float, and 1e-12 for the two ways of adding up in double.
            ASSERT_NEAR(e[i], exact[i], exact[i] * 0x1p-24 + 1e-12) << preset.name << " " << f << " " << b << " " << l;
            ASSERT_TRUE(e[i] >= 0 && e[i] <= 1 && e[i] <= e[3]);
          }
        }
      }
    }
  }
}

TEST(Table3d, DoesNotDependOnTheThreads) {
  const ExtinctionCurve curve = presetCurve("shells");
  const Table3d parallel = buildTable3d(curve, 24, 0.5);
  const ThreadLimit one(1);
  EXPECT_EQ(parallel.rgba, buildTable3d(curve, 24, 0.5).rgba);
}

TEST(Table3d, LocalChangeTouchesOnlyTheEntriesAcrossIt) {
  constexpr int kSize = 32;
  TransferFunction f = loadTransferFunction("viridis");
  const Table3d before = buildTable3d(makeCurve(f, {}), kSize, 0.5);
  f.points[6].opacity = 0.9;  // changes s in (5/9, 7/9)
  const Table3d after = buildTable3d(makeCurve(f, {}), kSize, 0.5);
  int changed = 0;
  for (int l = 0; l < kSize; ++l) {
    for (int b = 0; b < kSize; ++b) {
      for (int front = 0; front < kSize; ++front) {
        const float* x = entry(before, front, b, l);
        const float* y = entry(after, front, b, l);
        const bool same = std::equal(x, x + 4, y);
        const double low = std::min(front, b) / (kSize - 1.0), high = std::max(front, b) / (kSize - 1.0);
        const bool across = high >= 5.0 / 9 && low <= 7.0 / 9;
        ASSERT_TRUE(same || across) << front << " " << b << " " << l;
        changed += !same;
      }
    }
  }
  EXPECT_GT(changed, kSize * kSize * kSize / 4);
}

double interpolate(const Table3d& t, double f, double b, double l, int channel) {
  const double at[3] = {f * (t.size - 1), b * (t.size - 1), l * (t.size - 1)};
  int low[3];
  double share[3];
  for (int i = 0; i < 3; ++i) {
    low[i] = std::min(static_cast<int>(at[i]), t.size - 2);
    share[i] = at[i] - low[i];
  }
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1;
    int index[3];
    for (int i = 0; i < 3; ++i) {
      const int up = corner >> i & 1;
      weight *= up ? share[i] : 1 - share[i];
      index[i] = low[i] + up;
    }
    sum += weight * entry(t, index[0], index[1], index[2])[channel];
  }
  return sum;
}

TEST(Table3d, TrilinearInterpolationConvergesWithOrderTwo) {
  const ExtinctionCurve curve = smoothCurve();
  const auto error = [&](int size) {
    const Table3d table = buildTable3d(curve, size, 0.5);
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> unit(0, 1);
    double squares = 0;
    constexpr int kSamples = 3000;
    for (int i = 0; i < kSamples; ++i) {
      const double f = unit(random), b = unit(random), l = unit(random);
      const SegmentColor c = integrateSegment(curve, f, b, 0.5 * l);
      squares += std::pow(interpolate(table, f, b, l, 3) - c.alpha, 2) +
                 std::pow(interpolate(table, f, b, l, 0) - c.color[0], 2);
    }
    return std::sqrt(squares / kSamples);
  };
  const double coarse = error(9), middle = error(17), fine = error(33);
  EXPECT_NEAR(std::log2(coarse / middle), 2, 0.2);
  EXPECT_NEAR(std::log2(middle / fine), 2, 0.2);
}

TEST(Table3d, RefusesBadSizes) {
  const ExtinctionCurve curve = presetCurve("rainbow");
  for (int size : {-1, 0, 1, 513, 1 << 30}) EXPECT_THROW(buildTable3d(curve, size, 1), Error);
  EXPECT_THROW(buildTable3d(curve, 8, 0), Error);
  EXPECT_THROW(buildTable3d(curve, 8, std::nan("")), Error);
  EXPECT_EQ(buildTable3d(curve, 2, 1).rgba.size(), 32u);
}

TEST(Table3d, ProgressReachesTheEnd) {
  std::vector<double> told;
  buildTable3d(presetCurve("rainbow"), 8, 1, [&](std::string_view, double fraction) { told.push_back(fraction); });
  ASSERT_EQ(told.size(), 8u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1);
}

}  // namespace
}  // namespace havs
