#pragma once
// A curve cut at the lines of a grid over s: what all lengths of a table share.
#include <cstddef>
#include <vector>

#include "transfer/lanes.h"
#include "transfer/pieces.h"

namespace havs {

/// What lies on a stretch of the ray: its colour and opacity, and its optical depth.
struct Stretch {
  Rgba color{0, 0, 0, 0};
  double depth = 0;
};

inline Stretch over(const Stretch& front, const Stretch& back) {
  return {DoubleArithmetic::compositeUnder(front.color, back.color), front.depth + back.depth};
}

/// The light of one step of the grid as a series. With y of [0, 1] the share of the optical depth x that lies before a
/// place, light from there arrives with exp(-x y), so the colour is
///   x integral 0..1 of c(y) exp(-x y) dy = x sum over n of (-x)^n moment(n),  moment(n) = integral of c(y) y^n dy / n!
/// The moments are the same for all lengths: what a step costs does not grow with the knots in it.
struct StepSeries {
  static constexpr int kTerms = 18;         ///< 1 / 18! < 2^-52
  static constexpr int kShallowTerms = 10;  ///< 0.1^10 / 10! < 2^-52
  static constexpr double kDeepest = 1;     ///< optical depth up to which it serves
  static constexpr double kShallowDepth = 0.1;
  double depth = 0;  ///< optical depth for a length of 1 from s = 0 to s = 1
  Lanes moment[kTerms];
};

class GridPieces {
 public:
  /// Of one step, or of one of its pieces between knots.
  struct Piece {
    Rgba low;  // (r, g, b, kappa)
    Rgba high;
    double extent;
  };

  /// `curve` must outlive it. `added`: extinction that is added everywhere as the colours, not the depths, are
  /// integrated. Parallel.
  GridPieces(const ExtinctionCurve& curve, int lines, double added = 0);

  int lines() const { return lines_; }
  /// Steps [begin, end) in both senses, where the ray takes `lengthPerScalar` from s = 0 to s = 1, to
  /// result[begin .. end).
  void steps(int begin, int end, double lengthPerScalar, Lanes* result) const;
  /// Optical depth of step i, without what is added.
  double depthOf(int i, double lengthPerScalar) const { return depths_[i] * lengthPerScalar; }
  /// A stretch on which the scalar stays at line i.
  Stretch atLine(int i, double length) const;

 private:
  Rgba composite(int step, bool ascending, double lengthPerScalar) const;
  StepSeries seriesOf(int step) const;

  const ExtinctionCurve& curve_;
  int lines_;
  double added_;
  std::vector<Piece> pieces_;       ///< without what is added
  std::vector<std::size_t> first_;  ///< pieces of step i: [first[i], first[i + 1])
  std::vector<StepSeries> series_;
  std::vector<double> depths_;  ///< of the steps, without what is added, for a length of 1 from s = 0 to s = 1
};

}  // namespace havs
