#include "transfer/extinction_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "transfer/interpolate.h"
#include "transfer/resolution.h"
#include "transfer/transfer_files.h"

namespace havs {
namespace {

constexpr double kHighestOpacity = 1 - 0x1p-24;
constexpr double kHighestDepth = 24 * std::numbers::ln2;  // -ln(1 - kHighestOpacity)

/// More is noise: every point of TF.bin takes 4 on average then. 65,536 of full swings would become 21 million.
constexpr std::size_t kMostKnots = std::size_t{1} << 18;
/// All are looked through for every segment.
constexpr std::size_t kMostOpaque = 256;

using Points = std::vector<ControlPoint>;  // scalar is s here

ControlPoint between(const ControlPoint& a, const ControlPoint& b, double share) {
  const Shares shares(0, 1, share);
  return {shares.mix(a.scalar, b.scalar), shares.mix(a.color, b.color), shares.mix(a.opacity, b.opacity)};
}

/// See kStepMargin. Points that a step would pass go with it.
void lowerSteps(Points& points) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].scalar != points[i - 1].scalar || !(points[i].scalar > 0)) continue;
    const double lowered = points[i].scalar * (1 - kStepMargin);
    points[i].scalar = lowered;
    for (std::size_t j = i; j > 0 && points[j - 1].scalar > lowered; --j) points[j - 1].scalar = lowered;
  }
}

/// The function's points over s, cut to [0, 1] with points at both ends.
Points pointsOverDomain(const TransferFunction& function, const std::array<double, 2>& domain) {
  const double low = function.normalised ? 0 : domain[0];
  const double high = function.normalised ? 1 : domain[1];
  const auto endPoint = [&](double scalar, double s) {
    ControlPoint p = evaluate(function, scalar);
    p.scalar = s;
    return p;
  };
  Points points{endPoint(low, 0)};
  if (!(low < high)) {  // a field of one value
    points.push_back(endPoint(low, 1));
    return points;
  }
  for (ControlPoint p : function.points) {
    if (!(p.scalar > low && p.scalar <= high)) continue;
    p.scalar = Shares::ofData(low, high, p.scalar).upper;
    points.push_back(p);
  }
  lowerSteps(points);
  if (points.back().scalar < 1) points.push_back(endPoint(high, 1));
  return points;
}

/// Closed intervals of s where opacity is 1.
std::vector<std::array<double, 2>> opaqueIntervals(const Points& points) {
  std::vector<std::array<double, 2>> intervals;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].opacity < 1) continue;
    const double s = points[i].scalar;
    if (i > 0 && points[i - 1].opacity >= 1)
      intervals.back()[1] = s;
    else
      intervals.push_back({s, s});
  }
  return intervals;
}

/// Optical depth of a unit length. Linear in opacity for `extinction`.
double depthOfOpacity(double opacity, OpacityMeaning meaning) {
  return meaning == OpacityMeaning::extinction ? opacity : std::min(-std::log1p(-opacity), kHighestDepth);
}

/// Appends the points strictly between a and b that a line of g = -ln(1 - opacity) needs to stay within the tolerance,
/// relative to g. With q = sqrt(g), the chord between q1 and q2 is off by (q2 - q1)^2 / 2 of g at most, to first order,
/// wherever it lies: so knots at equal steps of q are the fewest.
void resample(const ControlPoint& a, const ControlPoint& b, double tolerance, Points& out) {
  constexpr double kSafety = 0.9;  // for the higher orders, next to opacity 1
  const bool rising = a.opacity < b.opacity;
  const ControlPoint& low = rising ? a : b;
  const ControlPoint& high = rising ? b : a;
  const double rise = high.opacity - low.opacity;
  const double highest = std::min(high.opacity, kHighestOpacity);
  if (!(low.opacity < highest)) return;
  const double q1 = std::sqrt(-std::log1p(-low.opacity));
  const double q2 = std::sqrt(-std::log1p(-highest));
  const int steps = std::max(1, static_cast<int>(std::ceil((q2 - q1) / (kSafety * std::sqrt(2 * tolerance)))));
  const int last = highest < high.opacity ? steps : steps - 1;  // the point where the cap is reached is a knot, too
  for (int k = 1; k <= last; ++k) {
    const double q = std::lerp(q1, q2, static_cast<double>(rising ? k : last + 1 - k) / steps);
    const double opacity = -std::expm1(-q * q);
    const double share = std::clamp((opacity - low.opacity) / rise, 0.0, 1.0);
    ControlPoint p = between(low, high, share);
    p.opacity = opacity;
    if (p.scalar > out.back().scalar && p.scalar < b.scalar) out.push_back(p);
  }
}

Points resampled(const Points& points, double tolerance) {
  Points out;
  for (const ControlPoint& p : points) {
    if (!out.empty() && p.scalar > out.back().scalar) resample(ControlPoint(out.back()), p, tolerance, out);
    out.push_back(p);
    if (out.size() > kMostKnots)
      failInput(fmt::format("opacity rises and falls so often that {} pieces do not draw it", kMostKnots),
                "transfer function", "smooth it, or give \"opacity\": \"extinction\"");
  }
  return out;
}

}  // namespace

double ExtinctionCurve::normalise(double value) const {
  const auto& [low, high] = domain;
  if (!(low < high)) return 0.5;
  return std::clamp(Shares::ofData(low, high, value).upper, 0.0, 1.0);
}

ExtinctionCurve::Knot ExtinctionCurve::at(double s) const {
  const auto above = std::upper_bound(knots.begin(), knots.end(), s, [](double x, const Knot& k) { return x < k.s; });
  if (above == knots.begin()) return knots.front();
  const Knot& below = *std::prev(above);
  if (above == knots.end()) return below;
  const Shares shares(below.s, above->s, s);
  return {s, shares.mix(below.color, above->color), shares.mix(below.kappa, above->kappa)};
}

ExtinctionCurve makeCurve(const TransferFunction& function, const CurveSetting& setting) {
  checkTransferFunction(function, "transfer function");
  ExtinctionCurve curve;
  curve.domain = function.domain.value_or(setting.fieldRange);
  curve.unitLength = function.unitLength.value_or(setting.boundingDiagonal / 20);
  if (!(curve.unitLength > 0 && std::isfinite(curve.unitLength))) {
    failInput(fmt::format("unit length {} is not positive", curve.unitLength), "transfer function",
              "give a length in mesh units");
  }
  if (!(setting.tolerance > 0))
    failInput(fmt::format("tolerance {} is not positive", setting.tolerance), "transfer function");

  Points points = pointsOverDomain(function, curve.domain);
  if (function.meaning == OpacityMeaning::perUnit) {
    curve.opaque = opaqueIntervals(points);
    if (curve.opaque.size() > kMostOpaque)
      failInput(fmt::format("opacity reaches 1 at {} places, each an opaque surface", curve.opaque.size()),
                "transfer function", fmt::format("{} are the most", kMostOpaque));
    points = resampled(points, setting.tolerance);
  }
  const double localPerUnit = setting.radius / curve.unitLength;
  for (const ControlPoint& p : points) {
    curve.knots.push_back({p.scalar, p.color, depthOfOpacity(p.opacity, function.meaning) * localPerUnit});
    curve.maximumKappa = std::max(curve.maximumKappa, curve.knots.back().kappa);
  }
  return curve;
}

ExtinctionCurve withoutOpaque(const ExtinctionCurve& curve) {
  using Knot = ExtinctionCurve::Knot;
  ExtinctionCurve bridged = curve;
  bridged.opaque.clear();
  for (const auto& [low, high] : curve.opaque) {
    std::vector<Knot>& knots = bridged.knots;
    const auto first = std::find_if(knots.begin(), knots.end(), [low = low](const Knot& k) { return k.s >= low; });
    const auto last = std::find_if(first, knots.end(), [high = high](const Knot& k) { return k.s > high; });
    Knot before = *first, after = *std::prev(last);  // at a step, its outer sides
    if (low <= 0) before = after;
    if (high >= 1) after = low <= 0 ? Knot{} : before;
    if (low <= 0 && high >= 1) before = Knot{};
    before.s = low;
    after.s = high;
    const auto place = knots.erase(first, last);
    knots.insert(place, {before, after});
  }
  return bridged;
}

ExtinctionCurve withSurfaceColors(const ExtinctionCurve& curve) {
  const ExtinctionCurve bridged = withoutOpaque(curve);
  ExtinctionCurve merged = bridged;
  for (const auto& [low, high] : curve.opaque) {
    std::vector<ExtinctionCurve::Knot> inside;
    for (std::size_t i = 0; i < curve.knots.size(); ++i) {
      ExtinctionCurve::Knot k = curve.knots[i];
      const bool below =
          k.s == low && i + 1 < curve.knots.size() && curve.knots[i + 1].s == low;  // a step's outer side
      const bool above = k.s == high && i > 0 && curve.knots[i - 1].s == high;
      if (k.s < low || k.s > high || (low < high && (below || above))) continue;
      k.kappa = bridged.at(k.s).kappa;
      inside.push_back(k);
    }
    auto& knots = merged.knots;
    const auto after = std::find_if(knots.rbegin(), knots.rend(), [high = high](const auto& k) { return k.s == high; });
    knots.insert(std::prev(after.base()), inside.begin(), inside.end());
  }
  return merged;
}

}  // namespace havs
