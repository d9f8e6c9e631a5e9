#include "light/extinction_integral.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace havs {
namespace {

constexpr std::size_t kRanges = 256;       // a power of two, so that finding a range does not round
constexpr double kLeastWidth = 0x1p-1000;  // of a piece; its inverse is finite

std::size_t rangeOf(double s) { return std::min(kRanges - 1, static_cast<std::size_t>(std::max(0.0, s * kRanges))); }

/// Simpson's rule, exact for kappa linear in r times r^2; no term is negative.
double cubicMoment(double r0, double r1, double kappa0, double kappa1) {
  const double middle = 0.5 * (r0 + r1);
  return (r1 - r0) / 6 * (kappa0 * r0 * r0 + 2 * (kappa0 + kappa1) * middle * middle + kappa1 * r1 * r1);
}

}  // namespace

ExtinctionIntegral::ExtinctionIntegral(const ExtinctionCurve& curve) : opaque_(curve.opaque) {
  // Prefix sums in two doubles: their differences stay exact to the last digits where little extinction follows much.
  double sum = 0, rest = 0;
  for (std::size_t i = 0; i + 1 < curve.knots.size(); ++i) {
    const auto &a = curve.knots[i], &b = curve.knots[i + 1];
    const double width = b.s - a.s;
    if (!(width > kLeastWidth)) continue;
    pieces_.push_back({a.s, b.s, 1 / width, a.kappa, b.kappa, sum, rest});
    const double area = 0.5 * (a.kappa + b.kappa) * width;
    const double total = sum + area, added = total - sum;
    rest += (sum - (total - added)) + (area - added);
    sum = total;
  }
  if (pieces_.empty()) {
    const double kappa = curve.knots.empty() ? 0 : curve.knots.back().kappa;
    pieces_.push_back({0, 1, 1, kappa, kappa, 0, 0});
  }
  std::uint32_t piece = 0;
  for (std::size_t range = 0; range < kRanges; ++range) {
    while (piece + 1 < pieces_.size() && pieces_[piece].end < static_cast<double>(range) / kRanges) ++piece;
    hint_.push_back(piece);
  }
}

std::size_t ExtinctionIntegral::pieceAbove(double s) const {
  std::size_t i = hint_[rangeOf(s)];
  while (i + 1 < pieces_.size() && pieces_[i].end <= s) ++i;
  return i;
}

std::size_t ExtinctionIntegral::pieceBelow(double s) const {
  std::size_t i = hint_[rangeOf(s)];
  while (i + 1 < pieces_.size() && pieces_[i].end < s) ++i;
  return i;
}

double ExtinctionIntegral::mean(double a, double b) const {
  const auto [low, high] = std::minmax(a, b);
  const std::size_t i = pieceAbove(low);
  const Piece& first = pieces_[i];
  const bool isLast = i + 1 == pieces_.size();  // a mean of scalars may lie above 1 by its rounding
  if (isLast || high <= first.end) return 0.5 * (first.kappa(low) + first.kappa(high));
  const std::size_t j = pieceBelow(high);
  const Piece &next = pieces_[i + 1], &last = pieces_[j];
  const double between = (last.sum - next.sum) + (last.rest - next.rest);
  return (0.5 * (first.kappa(low) + first.kappaEnd) * (first.end - low) + between +
          0.5 * (last.kappaBegin + last.kappa(high)) * (high - last.begin)) /
         (high - low);
}

double ExtinctionIntegral::secondMoment(double r0, double r1, double s0, double s1) const {
  if (s1 < s0) {
    std::swap(s0, s1);
    std::swap(r0, r1);
    return -secondMoment(r0, r1, s0, s1);
  }
  std::size_t i = pieceAbove(s0);
  if (s1 <= pieces_[i].end) return cubicMoment(r0, r1, pieces_[i].kappa(s0), pieces_[i].kappa(s1));
  double sum = 0, s = s0, r = r0;
  for (const std::size_t last = pieceBelow(s1); i <= last; ++i) {
    const Piece& piece = pieces_[i];
    const double end = i < last ? piece.end : s1;
    const double rEnd = i < last ? r0 + (r1 - r0) * ((end - s0) / (s1 - s0)) : r1;
    sum += cubicMoment(r, rEnd, piece.kappa(s), piece.kappa(end));
    s = end;
    r = rEnd;
  }
  return sum;
}

bool ExtinctionIntegral::isOpaque(double a, double b) const {
  const auto [low, high] = std::minmax(a, b);
  return std::any_of(opaque_.begin(), opaque_.end(), [low = low, high = high](const auto& interval) {
    return interval[0] <= high && low <= interval[1];
  });
}

}  // namespace havs
