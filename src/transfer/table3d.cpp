// The table of the paper, every entry exact (Moreland and Angel 2004 state the integral; docs/02-method.md has it as it
// is computed here). Front and back scalars of all entries lie on one grid of s. An entry that spans `span` steps of
// the grid on a length L sees the scalar change at the rate span / L, and so does every other entry of that span and
// length: the colour of each step of the grid at that rate is integrated once, and an entry is the composite of the
// steps it spans. A composite of `span` successive steps, for every start, takes three compositings each (van Herk
// 1992; Gil and Werman 1993): the grid is cut into blocks of `span` steps, and what spans a seam is a block's end over
// a block's start. No entry depends on steps it does not span.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <mutex>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "transfer/pieces.h"
#include "transfer/preintegration.h"

namespace havs {
namespace {

/// A stretch of s within one step of the grid and between two knots.
struct Piece {
  Rgba low;  // (r, g, b, kappa)
  Rgba high;
  double extent;
};

/// The pieces of every step of the grid, ascending: those of step i are [first[i], first[i + 1]).
struct GridPieces {
  std::vector<Piece> pieces;
  std::vector<std::size_t> first;
};

GridPieces cutIntoSteps(const ExtinctionCurve& curve, int steps) {
  GridPieces grid;
  for (int i = 0; i < steps; ++i) {
    grid.first.push_back(grid.pieces.size());
    visitPieces(curve, static_cast<double>(i) / steps, static_cast<double>(i + 1) / steps,
                [&](const Rgba& low, const Rgba& high, double extent) {
                  grid.pieces.push_back({low, high, extent});
                });
  }
  grid.first.push_back(grid.pieces.size());
  return grid;
}

Rgba over(const Rgba& front, const Rgba& back) { return DoubleArithmetic::compositeUnder(front, back); }

/// Composites of successive elements. front to back is ascending (low scalar in front) or descending.
class SlidingComposite {
 public:
  explicit SlidingComposite(bool ascending) : ascending_(ascending) {}

  /// Prepares at(i) for windows of `span` of `elements`.
  void prepare(const std::vector<Rgba>& elements, int span) {
    const int count = static_cast<int>(elements.size());
    span_ = span;
    fromBlockStart_ = elements;
    toBlockEnd_ = elements;
    for (int i = 1; i < count; ++i) {
      if (i % span != 0) fromBlockStart_[i] = join(fromBlockStart_[i - 1], elements[i]);
    }
    for (int i = count - 2; i >= 0; --i) {
      if ((i + 1) % span != 0) toBlockEnd_[i] = join(elements[i], toBlockEnd_[i + 1]);
    }
  }
  /// The composite of elements first ... first + span - 1.
  Rgba at(int first) const {
    if (first % span_ == 0) return fromBlockStart_[first + span_ - 1];
    return join(toBlockEnd_[first], fromBlockStart_[first + span_ - 1]);
  }

 private:
  Rgba join(const Rgba& lower, const Rgba& upper) const { return ascending_ ? over(lower, upper) : over(upper, lower); }

  bool ascending_;
  int span_ = 1;
  std::vector<Rgba> fromBlockStart_;
  std::vector<Rgba> toBlockEnd_;
};

/// Fills all entries of one length.
class LayerBuilder {
 public:
  LayerBuilder(const ExtinctionCurve& curve, const GridPieces& grid, int size)
      : curve_(curve), grid_(grid), size_(size), steps_(size - 1), upward_(size - 1), downward_(size - 1) {}

  /// `layer`: the size * size entries of this length.
  void build(double length, float* layer) {
    for (int i = 0; i < size_; ++i) {
      const ExtinctionCurve::Knot k = curve_.at(static_cast<double>(i) / steps_);
      const Rgba sample(k.color[0], k.color[1], k.color[2], k.kappa);
      store(layer, i, i, integratePiece(sample, sample, length));
    }
    for (int span = 1; span <= steps_; ++span) {
      integrateSteps(length * steps_ / span);
      ascending_.prepare(upward_, span);
      descending_.prepare(downward_, span);
      for (int low = 0; low + span <= steps_; ++low) {
        store(layer, low, low + span, ascending_.at(low));
        store(layer, low + span, low, descending_.at(low));
      }
    }
  }

 private:
  /// Every step of the grid, seen from below and from above, where the ray takes `lengthPerScalar` from s = 0 to s = 1.
  void integrateSteps(double lengthPerScalar) {
    for (int i = 0; i < steps_; ++i) {
      Rgba up(0, 0, 0, 0);
      Rgba down(0, 0, 0, 0);
      for (std::size_t p = grid_.first[i]; p < grid_.first[i + 1]; ++p) {
        const Piece& piece = grid_.pieces[p];
        const double length = piece.extent * lengthPerScalar;
        up = over(up, integratePiece(piece.low, piece.high, length));
        down = over(integratePiece(piece.high, piece.low, length), down);
      }
      upward_[i] = up;
      downward_[i] = down;
    }
  }

  void store(float* layer, int front, int back, const Rgba& c) const {
    float* entry = layer + (static_cast<std::size_t>(back) * size_ + front) * 4;
    entry[0] = static_cast<float>(c.r);
    entry[1] = static_cast<float>(c.g);
    entry[2] = static_cast<float>(c.b);
    entry[3] = static_cast<float>(c.a);
  }

  const ExtinctionCurve& curve_;
  const GridPieces& grid_;
  int size_;
  int steps_;
  std::vector<Rgba> upward_;    // each step of the grid with its low end in front
  std::vector<Rgba> downward_;  // with its high end in front
  SlidingComposite ascending_{true};
  SlidingComposite descending_{false};
};

}  // namespace

Table3d buildTable3d(const ExtinctionCurve& curve, int size, double maximumLength, const Progress& progress) {
  constexpr int kLargestSize = 512;
  if (size < 2 || size > kLargestSize)
    failInput(fmt::format("a table of {} entries along each axis", size), "table size", "choose 2 to 512");
  if (!(maximumLength > 0 && std::isfinite(maximumLength)))
    failInput(fmt::format("length {} is not positive", maximumLength), "table");
  Table3d table{.size = size, .maximumLength = maximumLength};
  const std::size_t layerFloats = std::size_t{4} * size * size;
  table.rgba.resize(layerFloats * size);
  const GridPieces grid = cutIntoSteps(curve, size - 1);
  std::mutex progressMutex;
  int done = 0;
  parallelBlocks(0, size, 1, [&](std::size_t first, std::size_t last) {
    LayerBuilder builder(curve, grid, size);
    for (std::size_t l = first; l < last; ++l) {
      builder.build(maximumLength * static_cast<double>(l) / (size - 1), &table.rgba[l * layerFloats]);
      if (!progress) continue;
      const std::lock_guard lock(progressMutex);
      progress("table", static_cast<double>(++done) / size);
    }
  });
  return table;
}

std::vector<unsigned char> toRgba8(const Table3d& table) {
  std::vector<unsigned char> bytes(table.rgba.size());
  parallelFor(0, bytes.size(), 1 << 16,
              [&](std::size_t i) { bytes[i] = static_cast<unsigned char>(std::lround(255 * table.rgba[i])); });
  return bytes;
}

}  // namespace havs
