#include "transfer/resolution.h"

#include <algorithm>
#include <cmath>

namespace havs {
namespace {

constexpr double kVisible = 1.0 / 256;

bool isLike(const ControlPoint& a, const ControlPoint& b, double greatestOpacity) {
  for (std::size_t c = 0; c < 3; ++c)
    if (!(std::abs(a.color[c] - b.color[c]) <= kVisible)) return false;
  return std::abs(a.opacity - b.opacity) <= kVisible * greatestOpacity;
}

}  // namespace

bool holdsInFloat(const TransferFunction& function, const ExtinctionCurve& curve, double value) {
  const auto& [low, high] = curve.domain;
  if (function.normalised || !(low < high)) return true;
  double greatest = 0;
  for (const ControlPoint& p : function.points) greatest = std::max(greatest, p.opacity);
  const ControlPoint asked = evaluate(function, std::clamp(value, low, high));
  const auto scalar = static_cast<double>(static_cast<float>(curve.normalise(value)));
  for (const double place : {scalar, scalar * (1 + kStepMargin)})  // steps are lower by that much
    if (isLike(asked, evaluate(function, std::lerp(low, high, std::min(place, 1.0))), greatest)) return true;
  return false;
}

}  // namespace havs
