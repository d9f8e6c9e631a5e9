#pragma once
// How tables over (front scalar, back scalar) are filled, one length at a time, every entry exact (Moreland and Angel
// 2004 state the integral; docs/02-method.md has it as it is computed here). Front and back scalars of all entries lie
// on one grid of s. An entry that spans `span` steps of the grid on a length L sees the scalar change at the rate
// span / L, and so does every other entry of that span and length: the colour of each step of the grid at that rate is
// taken from a series (transfer/grid_pieces.h), and an entry is the composite of the steps it spans. A composite of
// `span` successive steps, for every start, takes three compositings each (van Herk 1992; Gil and Werman 1993): the
// grid is cut into blocks of `span` steps, and what spans a seam is a block's end over a block's start. No entry
// depends on steps it does not span, and which other entries are built with it changes nothing: so a part can be built
// anew, equal bit for bit.
#include <algorithm>
#include <vector>

#include "transfer/grid_pieces.h"

namespace havs {

/// The steps of a grid over s that a change of the curve touches: entries between grid lines i and j change only where
/// [min(i, j), max(i, j)] meets [first, last]. None: first > last.
struct TouchedLines {
  int first;
  int last;
};

/// Builds the entries of one length. One object a thread.
class LayerBuilder {
 public:
  /// `withDepths`: stretches get their optical depth, too.
  explicit LayerBuilder(const GridPieces& grid, bool withDepths = false);

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
    compose(length * steps_ / span, span, begin, end);
    for (int low = begin; low < end; ++low) {
      const auto& c = windows_[low].value;
      const double depth = withDepths_ ? depths_[low] : 0;
      store(low, low + span, Stretch{{c[0], c[1], c[2], c[3]}, depth});
      store(low + span, low, Stretch{{c[4], c[5], c[6], c[7]}, depth});
    }
  }

 private:
  void compose(double lengthPerScalar, int span, int begin, int end);
  void composeDepths(double lengthPerScalar, int span, int begin, int end);

  const GridPieces& grid_;
  int steps_;
  bool withDepths_;
  std::vector<Lanes> elements_;        // the steps
  std::vector<Lanes> fromBlockStart_;  // composites of a block's steps up to this one
  std::vector<Lanes> toBlockEnd_;      // and from this one on
  std::vector<Lanes> windows_;         // of `span` steps from this one on
  std::vector<double> depths_;         // of the same
  std::vector<double> depthFromBlockStart_;
  std::vector<double> depthToBlockEnd_;
};

}  // namespace havs
