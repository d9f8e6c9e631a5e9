#include "transfer/curve_change.h"

#include <algorithm>
#include <cmath>

namespace havs {

TouchedLines touchedLines(const ExtinctionCurve& before, const ExtinctionCurve& after, int lines) {
  const auto same = [](const auto& a, const auto& b) { return a.s == b.s && a.kappa == b.kappa && a.color == b.color; };
  const auto& a = before.knots;
  const auto& b = after.knots;
  const auto [left, leftOther] = std::mismatch(a.begin(), a.end(), b.begin(), b.end(), same);
  if (left == a.end() && leftOther == b.end()) return {0, -1};
  const auto [right, rightOther] = std::mismatch(a.rbegin(), a.rend(), b.rbegin(), b.rend(), same);
  const double low = left == a.begin() ? 0.0 : std::prev(left)->s;
  const double high = right == a.rbegin() ? 1.0 : std::prev(right)->s;
  // A line is at i / (lines - 1) as rounded; one more on either side costs little.
  const int first = static_cast<int>(std::ceil(low * (lines - 1))) - 1;
  const int last = static_cast<int>(std::floor(high * (lines - 1))) + 1;
  return {std::max(0, first), std::min(lines - 1, last)};
}

}  // namespace havs
