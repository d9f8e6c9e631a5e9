#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "reference/cell_segments.h"
#include "scene/isosurface.h"

namespace havs {

/// Where the segments of a ray cross isosurfaces (scene/isosurface.h). One for each ray, asked for its segments in
/// order.
class Crossings {
 public:
  /// `surfaces`: ascending by scalar.
  explicit Crossings(std::span<const ShownIsosurface> surfaces) : surfaces_(surfaces) {}

  /// Calls visit(surface, share) for the surfaces that a segment crosses, in the order of the ray; share: of its way,
  /// of [0, 1].
  template <class Visit>
  void visit(const CellSegment& s, const Visit& visit) {
    if (surfaces_.empty()) return;
    std::size_t below = upTo(goesOn(s) ? scalarReached_ : s.scalarEntry);
    const std::size_t last = upTo(s.scalarExit);
    const auto share = [&](const ShownIsosurface& surface) {
      const double difference = s.scalarExit - s.scalarEntry;
      return difference == 0 ? 0.0 : std::clamp((surface.scalar - s.scalarEntry) / difference, 0.0, 1.0);
    };
    for (; below < last; ++below) visit(surfaces_[below], share(surfaces_[below]));
    for (; below > last; --below) visit(surfaces_[below - 1], share(surfaces_[below - 1]));
    reached_ = s.exit;
    scalarReached_ = s.scalarExit;
  }

 private:
  static constexpr double kRounding = 1e-9;

  /// Whether it begins where the one before it ended, up to rounding: there the ray has one scalar, so that a surface
  /// is neither missed nor crossed twice.
  bool goesOn(const CellSegment& s) const {
    return s.entry == reached_ && std::abs(s.scalarEntry - scalarReached_) < kRounding;
  }
  /// The number of surfaces at or below a scalar.
  std::size_t upTo(double scalar) const {
    const auto above = std::upper_bound(surfaces_.begin(), surfaces_.end(), scalar,
                                        [](double s, const ShownIsosurface& surface) { return s < surface.scalar; });
    return static_cast<std::size_t>(above - surfaces_.begin());
  }

  std::span<const ShownIsosurface> surfaces_;
  double reached_ = -std::numeric_limits<double>::infinity();
  double scalarReached_ = 0;
};

}  // namespace havs
