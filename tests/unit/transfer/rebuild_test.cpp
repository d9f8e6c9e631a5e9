// A table brought up to date after a local change of the transfer function equals one built anew, bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "transfer/curve_change.h"
#include "transfer/mean_tables.h"
#include "transfer/preintegration.h"

namespace havs {
namespace {

constexpr int kSize = 16;
constexpr double kLength = 0.4;

ExtinctionCurve curveOf(const TransferFunction& function) { return withoutOpaque(makeCurve(function, {})); }

/// One local edit: a control point's opacity or colour, also of the first or last; a point moved; a point or a step put
/// in; a point made opaque, or no more; a point taken out.
void edit(TransferFunction& function, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  auto& points = function.points;
  const auto anyOf = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  const std::size_t i = random() % 4 == 0 ? (random() % 2 ? 0 : points.size() - 1) : anyOf(points.size());
  switch (random() % 6) {
    case 0:
      points[i].opacity = unit(random);
      break;
    case 1:
      points[i].color = {unit(random), unit(random), unit(random)};
      break;
    case 2:
      points[i].opacity = points[i].opacity >= 1 ? 0.5 : 1;
      break;
    case 3:
      if (i > 0 && i + 1 < points.size())
        points[i].scalar = points[i - 1].scalar + unit(random) * (points[i + 1].scalar - points[i - 1].scalar);
      break;
    case 4: {
      ControlPoint point = evaluate(function, unit(random));
      const auto place = std::upper_bound(points.begin(), points.end(), point.scalar,
                                          [](double s, const ControlPoint& p) { return s < p.scalar; });
      ControlPoint upper = point;
      upper.opacity = unit(random);
      points.insert(place, {point, upper});
      break;
    }
    default:
      if (points.size() > 3) points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

TEST(Rebuild, EqualsAFullBuildAfterRandomLocalEdits) {
  std::mt19937 random(9);
  std::size_t touchedLess = 0;
  for (const TransferPreset& preset : transferPresets()) {
    TransferFunction function = preset.function;
    ExtinctionCurve curve = curveOf(function);
    Table3d table = buildTable3d(curve, kSize, kLength), means = buildMeanColors(curve, kSize / 2, kLength);
    MeanTable2d flat = buildMeanTable2d(curve, kSize, kLength);
    for (int i = 0; i < 12; ++i) {
      edit(function, random);
      const ExtinctionCurve after = curveOf(function);
      const TouchedLines touched = touchedLines(curve, after, kSize);
      touchedLess += touched.first > 0 || touched.last < kSize - 1;
      rebuildTable3d(table, curve, after);
      rebuildMeanColors(means, curve, after);
      rebuildMeanTable2d(flat, curve, after);
      ASSERT_EQ(table.rgba, buildTable3d(after, kSize, kLength).rgba) << preset.name << ", edit " << i;
      ASSERT_EQ(means.rgba, buildMeanColors(after, kSize / 2, kLength).rgba) << preset.name << ", edit " << i;
      ASSERT_EQ(flat.rgba, buildMeanTable2d(after, kSize, kLength).rgba) << preset.name << ", edit " << i;
      curve = after;
    }
  }
  EXPECT_GT(touchedLess, 40u) << "hardly any of the 96 edits was local";
}

TEST(Rebuild, LeavesWhatTheChangeDoesNotTouch) {
  TransferFunction function = loadTransferFunction("viridis");
  const ExtinctionCurve before = curveOf(function);
  function.points[6].opacity = 0.9;  // changes s in (5/9, 7/9)
  const ExtinctionCurve after = curveOf(function);
  Table3d table = buildTable3d(before, kSize, kLength);
  std::fill(table.rgba.begin(), table.rgba.end(), -1.0F);
  rebuildTable3d(table, before, after);
  std::size_t built = 0;
  for (std::size_t i = 0; i < table.rgba.size(); i += 4) {
    const std::size_t entry = i / 4, front = entry % kSize, back = entry / kSize % kSize;
    const double low = static_cast<double>(std::min(front, back)) / (kSize - 1);
    const double high = static_cast<double>(std::max(front, back)) / (kSize - 1);
    const bool across = high >= 5.0 / 9 && low <= 7.0 / 9;
    const bool next = high >= 5.0 / 9 - 2.0 / kSize && low <= 7.0 / 9 + 2.0 / kSize;  // lines are taken one more
    ASSERT_EQ(table.rgba[i] >= 0, across || (next && table.rgba[i] >= 0)) << front << " " << back;
    built += table.rgba[i] >= 0;
  }
  EXPECT_LT(built, table.rgba.size() / 4 * 9 / 10);
}

TEST(Rebuild, OfTheSameCurveDoesNothing) {
  const ExtinctionCurve curve = curveOf(loadTransferFunction("shells"));
  Table3d table = buildTable3d(curve, kSize, kLength);
  std::fill(table.rgba.begin(), table.rgba.end(), -1.0F);
  rebuildTable3d(table, curve, curve);
  EXPECT_EQ(*std::max_element(table.rgba.begin(), table.rgba.end()), -1.0F);
}

}  // namespace
}  // namespace havs
