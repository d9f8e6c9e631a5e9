#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "transfer/extinction_curve.h"

namespace havs {

/// The extinction of a curve, made ready to be averaged over ranges of the scalar. Scalars are of [0, 1],
/// or beyond its ends by the rounding of a mean.
class ExtinctionIntegral {
 public:
  explicit ExtinctionIntegral(const ExtinctionCurve& curve);

  /// The mean of kappa over the scalars between a and b, whichever is larger: times its length, the optical depth of a
  /// stretch of a ray on which the scalar is linear. Exact but for rounding, of which each result has a few units in
  /// its last digits, however close a and b are. a == b: kappa there, at a step that of the upper side.
  double mean(double a, double b) const;

  /// The integral of kappa(s(r)) r^2 over r from r0 to r1, where s goes linearly from s0 to s1; r1 may be less than r0.
  double secondMoment(double r0, double r1, double s0, double s1) const;

  /// Whether a scalar between a and b lies in an opaque interval of the curve (both closed).
  bool isOpaque(double a, double b) const;

 private:
  /// Between two knots; kappa is linear. `sum` + `rest`: the integral of kappa over all pieces before it.
  struct Piece {
    double begin, end, perWidth, kappaBegin, kappaEnd, sum, rest;
    double kappa(double s) const { return ((end - s) * kappaBegin + (s - begin) * kappaEnd) * perWidth; }
  };
  std::size_t pieceAbove(double s) const;  ///< that has s and, but at the end of the curve, what follows on it
  std::size_t pieceBelow(double s) const;  ///< that has s and, but at the beginning, what precedes it

  std::vector<Piece> pieces_;        ///< ascending, without gaps; at least one
  std::vector<std::uint32_t> hint_;  ///< by ranges of s: the first piece that ends in one or after it
  std::vector<std::array<double, 2>> opaque_;
};

}  // namespace havs
