#pragma once
// A segment of a ray cut at the knots of the curve, so that colour and extinction are linear on each piece.
#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"
#include "transfer/extinction_curve.h"
#include "transfer/interpolate.h"

namespace havs {

using DoubleArithmetic = Arithmetic<DoubleLane>;
using Rgba = DoubleArithmetic::Rgba;

/// (r, g, b, kappa) between two knots.
inline Rgba sampleBetween(const ExtinctionCurve::Knot& a, const ExtinctionCurve::Knot& b, double s) {
  const Shares shares(a.s, b.s, s);
  const std::array<double, 3> color = shares.mix(a.color, b.color);
  return {color[0], color[1], color[2], shares.mix(a.kappa, b.kappa)};
}

/// Calls visit(atStart, atEnd, extent) for each piece from `from` to `to` (of [0, 1], in either direction), in that
/// order: (r, g, b, kappa) at both ends of the piece and its extent in s, > 0.
template <class Visit>
void visitPieces(const ExtinctionCurve& curve, double from, double to, const Visit& visit) {
  const auto& knots = curve.knots;
  if (from < to) {
    auto next = std::upper_bound(knots.begin(), knots.end(), from, [](double s, const auto& k) { return s < k.s; });
    for (double s = from; s < to && next != knots.end(); s = next->s, ++next) {
      const double end = std::min(to, next->s);
      if (end > s)
        visit(sampleBetween(*std::prev(next), *next, s), sampleBetween(*std::prev(next), *next, end), end - s);
    }
  } else {
    auto next = std::lower_bound(knots.begin(), knots.end(), from, [](const auto& k, double s) { return k.s < s; });
    for (double s = from; s > to && next != knots.begin(); s = next->s) {
      const auto upper = next--;
      const double end = std::max(to, next->s);
      if (end < s) visit(sampleBetween(*next, *upper, s), sampleBetween(*next, *upper, end), s - end);
    }
  }
}

/// weightsByRule of a thin piece, optical depth at most kShallowDepth: nothing is out of light's reach, and exp needs
/// but a few terms. As exact, in half the time.
inline DoubleArithmetic::SegmentWeights thinWeights(double atFront, double atBack) {
  using A = DoubleArithmetic;
  constexpr int kTerms = 9;  // 0.1^10 / 10! < 2^-53 / 1000
  double front = 0, back = 0;
  for (int i = 0; i < A::kShallowNodes; ++i) {
    const double s = A::kNode[i];
    const double slope = atFront * (1 - s) + atBack * s;
    const double x = -0.5 * s * (atFront + slope);
    double exponential = A::kInverseFactorial[kTerms];
    for (int term = kTerms - 1; term >= 0; --term) exponential = exponential * x + A::kInverseFactorial[term];
    const double light = A::kNodeWeight[i] * slope * exponential;
    front += (1 - s) * light;
    back += s * light;
  }
  return {front, back, front + back};
}

/// The exact integral over one piece, with no more nodes than its optical depth needs.
inline Rgba integratePiece(const Rgba& front, const Rgba& back, double length) {
  using A = DoubleArithmetic;
  const double atFront = front.a * length;
  const double atBack = back.a * length;
  const double depth = (atFront + atBack) / 2;
  if (!(depth > 0)) return {0, 0, 0, 0};
  if (depth <= A::kShallowDepth) return A::weightedColor(front, back, thinWeights(atFront, atBack));
  if (depth <= A::kMiddleDepth) {
    return A::weightedColor(front, back, A::weightsByRule(atFront, atBack, A::kFirstMiddleNode, A::kMiddleNodes));
  }
  return A::linearPiece(front, back, length);
}

}  // namespace havs
