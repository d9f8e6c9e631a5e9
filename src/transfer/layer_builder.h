#pragma once
// How tables over (front scalar, back scalar) are filled, one length at a time, every entry exact (Moreland and Angel
// 2004 state the integral; docs/02-method.md has it as it is computed here). Front and back scalars of all entries lie
// on one grid of s. An entry that spans `span` steps of the grid on a length L sees the scalar change at the rate
// span / L, and so does every other entry of that span and length: the colour of each step of the grid at that rate is
// integrated once, and an entry is the composite of the steps it spans. A composite of `span` successive steps, for
// every start, takes three compositings each (van Herk 1992; Gil and Werman 1993): the grid is cut into blocks of
// `span` steps, and what spans a seam is a block's end over a block's start. No entry depends on steps it does not
// span, and which other entries are built with it changes nothing: so a part can be built anew, equal bit for bit.
#include <algorithm>
#include <cstddef>
#include <vector>

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

/// The steps of a grid over s that a change of the curve touches: entries between grid lines i and j change only where
/// [min(i, j), max(i, j)] meets [first, last]. None: first > last.
struct TouchedLines {
  int first;
  int last;
};

/// Composites of successive elements. front to back is ascending (low scalar in front) or descending.
class SlidingComposite {
 public:
  explicit SlidingComposite(bool ascending) : ascending_(ascending) {}

  /// Prepares at(i) for the windows of `span` that lie within elements [begin, end).
  void prepare(const std::vector<Stretch>& elements, int span, int begin, int end) {
    span_ = span;
    fromBlockStart_.resize(elements.size());
    toBlockEnd_.resize(elements.size());
    for (int i = begin; i < end; ++i) {
      const bool starts = i == begin || i % span == 0;
      fromBlockStart_[i] = starts ? elements[i] : join(fromBlockStart_[i - 1], elements[i]);
    }
    for (int i = end - 1; i >= begin; --i) {
      const bool ends = i == end - 1 || (i + 1) % span == 0;
      toBlockEnd_[i] = ends ? elements[i] : join(elements[i], toBlockEnd_[i + 1]);
    }
  }
  /// The composite of elements first ... first + span - 1.
  Stretch at(int first) const {
    if (first % span_ == 0) return fromBlockStart_[first + span_ - 1];
    return join(toBlockEnd_[first], fromBlockStart_[first + span_ - 1]);
  }

 private:
  Stretch join(const Stretch& lower, const Stretch& upper) const {
    return ascending_ ? over(lower, upper) : over(upper, lower);
  }

  bool ascending_;
  int span_ = 1;
  std::vector<Stretch> fromBlockStart_;
  std::vector<Stretch> toBlockEnd_;
};

/// A curve cut at the lines of a grid: what all lengths share. `added`: extinction that is added everywhere as the
/// colours, not the depths, are integrated.
class GridPieces {
 public:
  /// Of one step, or of one of its pieces between knots.
  struct Piece {
    Rgba low;  // (r, g, b, kappa)
    Rgba high;
    double extent;
  };

  GridPieces(const ExtinctionCurve& curve, int lines, double added = 0) : curve_(curve), lines_(lines), added_(added) {
    const int steps = lines - 1;
    for (int i = 0; i < steps; ++i) {
      first_.push_back(pieces_.size());
      visitPieces(curve, static_cast<double>(i) / steps, static_cast<double>(i + 1) / steps,
                  [&](const Rgba& low, const Rgba& high, double extent) {
                    pieces_.push_back({low, high, extent});
                  });
    }
    first_.push_back(pieces_.size());
  }

  int lines() const { return lines_; }
  /// Step i from its low to its high end, or back, where the ray takes `lengthPerScalar` from s = 0 to s = 1.
  Stretch step(int i, bool ascending, double lengthPerScalar) const {
    Stretch sum;
    for (std::size_t p = first_[i]; p < first_[i + 1]; ++p) {
      const Piece& piece = pieces_[p];
      const double length = piece.extent * lengthPerScalar;
      sum = ascending ? over(sum, stretch(piece.low, piece.high, length))
                      : over(stretch(piece.high, piece.low, length), sum);
    }
    return sum;
  }
  /// A stretch on which the scalar stays at line i.
  Stretch atLine(int i, double length) const {
    const ExtinctionCurve::Knot k = curve_.at(static_cast<double>(i) / (lines_ - 1));
    const Rgba sample(k.color[0], k.color[1], k.color[2], k.kappa);
    return stretch(sample, sample, length);
  }

 private:
  Stretch stretch(Rgba front, Rgba back, double length) const {
    const double depth = 0.5 * (front.a + back.a) * length;
    front.a += added_;
    back.a += added_;
    return {integratePiece(front, back, length), depth};
  }

  const ExtinctionCurve& curve_;
  int lines_;
  double added_;
  std::vector<Piece> pieces_;
  std::vector<std::size_t> first_;  // pieces of step i: [first[i], first[i + 1])
};

/// Builds the entries of one length. One object a thread.
class LayerBuilder {
 public:
  explicit LayerBuilder(const GridPieces& grid)
      : grid_(grid), steps_(grid.lines() - 1), upward_(grid.lines() - 1), downward_(grid.lines() - 1) {}

  /// Calls store(front, back, stretch) for each touched entry whose lines are `span` steps apart.
  template <class Store>
  void build(double length, int span, const TouchedLines& touched, const Store& store) {
    const int begin = std::max(0, touched.first - span);
    const int end = std::min(touched.last, steps_ - span) + 1;  // of the low lines
    if (begin >= end) return;
    if (span == 0) {
      for (int i = begin; i < end; ++i) store(i, i, grid_.atLine(i, length));
      return;
    }
    const int lastStep = end - 1 + span;
    for (int i = begin; i < lastStep; ++i) {
      upward_[i] = grid_.step(i, true, length * steps_ / span);
      downward_[i] = grid_.step(i, false, length * steps_ / span);
    }
    ascending_.prepare(upward_, span, begin, lastStep);
    descending_.prepare(downward_, span, begin, lastStep);
    for (int low = begin; low < end; ++low) {
      store(low, low + span, ascending_.at(low));
      store(low + span, low, descending_.at(low));
    }
  }

 private:
  const GridPieces& grid_;
  int steps_;
  std::vector<Stretch> upward_;    // each step of the grid with its low end in front
  std::vector<Stretch> downward_;  // with its high end in front
  SlidingComposite ascending_{true};
  SlidingComposite descending_{false};
};

}  // namespace havs
