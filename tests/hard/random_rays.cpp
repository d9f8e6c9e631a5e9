#include "hard/random_rays.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace havs::test {
namespace {

struct Fragment {
  double distance, scalar;
  bool inside;  ///< whether a segment begins here
};
using Fragments = std::vector<Fragment>;

/// The faces that a ray meets: where one segment ends and the next begins is one of them.
Fragments fragmentsOf(std::span<const CellSegment> segments, bool cellData) {
  Fragments fragments;
  for (const CellSegment& s : segments) {
    const bool goesOn = !fragments.empty() && fragments.back().distance == s.entry &&
                        (cellData || fragments.back().scalar == s.scalarEntry);
    if (goesOn) fragments.pop_back();
    fragments.push_back({s.entry, s.scalarEntry, true});
    fragments.push_back({s.exit, s.scalarExit, false});
  }
  return fragments;
}

std::vector<CellSegment> segmentsOf(const Fragments& fragments, bool cellData) {
  std::vector<CellSegment> segments;
  for (std::size_t i = 0; i + 1 < fragments.size(); ++i) {
    const Fragment &front = fragments[i], &back = fragments[i + 1];
    if (!front.inside) continue;
    segments.push_back({front.distance, std::max(front.distance, back.distance), front.scalar,
                        cellData ? front.scalar : back.scalar, kNoIndex});
  }
  return segments;
}

double difference(const RayColor& a, const RayColor& b) {
  double most = 0;
  for (std::size_t c = 0; c < 4; ++c) most = std::max(most, std::abs(a[c] - b[c]));
  return most;
}

/// A ray and what becomes of its colour when its fragments change.
class Moves {
 public:
  Moves(const RayScene& scene, RayFunction function, Fragments fragments, bool cellData)
      : scene_(scene), function_(function), fragments_(std::move(fragments)), cellData_(cellData) {
    color_ = colorOf(fragments_);
    for (const auto& interval : scene.curve.opaque) surfaces_.insert(surfaces_.end(), interval.begin(), interval.end());
    for (const ShownIsosurface& surface : scene.isosurfaces) surfaces_.push_back(surface.scalar);
  }

  double ofNumbers(std::size_t i, const FragmentErrors& errors) const {
    const double scalar = fragments_[i].scalar, least = scalar - errors.scalar, most = scalar + errors.scalar;
    double scalars = std::max(withScalar(i, least), withScalar(i, most)), distances = 0;
    for (const double surface : surfaces_)  // in a cell of one value it is met at this value alone
      if (least < surface && surface < most) scalars = std::max(scalars, withScalar(i, surface));
    for (const double sign : {-1.0, 1.0}) {
      Fragments moved = fragments_;
      moved[i].distance += sign * errors.distance;
      distances = std::max(distances, difference(colorOf(moved), color_));
    }
    return scalars + distances;
  }

  /// Any of the fragments [first, last) as the first or the last of them, or after the segment that it ends was drawn
  /// to one of its neighbours.
  double ofOrder(std::size_t first, std::size_t last) const {
    double most = 0;
    for (std::size_t i = first; i < last; ++i) {
      most = std::max(most, difference(colorOf(moved(i, first)), color_));
      most = std::max(most, difference(colorOf(moved(i, last - 1)), color_));
      for (const std::size_t neighbour : {i - 1, i + 1}) {
        if (neighbour < first || neighbour >= last) continue;
        Fragments skipped = fragments_;
        skipped[i].scalar = skipped[neighbour].scalar;
        most = std::max(most, difference(colorOf(skipped), color_));
      }
    }
    return most;
  }

  /// Without what lies between the fragments [first, last): with inner faces before the entry, the ray is outside
  /// there.
  double ofMissing(std::size_t first, std::size_t last) const {
    Fragments moved = fragments_;
    for (std::size_t i = first; i + 1 < last; ++i) moved[i].inside = false;
    return difference(colorOf(moved), color_);
  }

  const Fragments& fragments() const { return fragments_; }

 private:
  double withScalar(std::size_t i, double scalar) const {
    Fragments moved = fragments_;
    moved[i].scalar = std::clamp(scalar, 0.0, 1.0);
    return difference(colorOf(moved), color_);
  }
  RayColor colorOf(const Fragments& fragments) const { return function_(scene_, segmentsOf(fragments, cellData_)); }
  /// With the scalar of `from` moved to the place `to`; where the ray is inside stays.
  Fragments moved(std::size_t from, std::size_t to) const {
    Fragments result = fragments_;
    const double scalar = result[from].scalar;
    for (; from < to; ++from) result[from].scalar = result[from + 1].scalar;
    for (; from > to; --from) result[from].scalar = result[from - 1].scalar;
    result[to].scalar = scalar;
    return result;
  }

  RayScene scene_;
  RayFunction function_;
  Fragments fragments_;
  bool cellData_;
  RayColor color_{};
  std::vector<double> surfaces_;
};

}  // namespace

double floatEffect(const RayScene& scene, RayFunction function, std::span<const CellSegment> segments, bool cellData,
                   const FragmentErrors& errors) {
  const Moves moves(scene, function, fragmentsOf(segments, cellData), cellData);
  const Fragments& fragments = moves.fragments();
  double sum = 0;
  for (std::size_t i = 0; i < fragments.size(); ++i) sum += moves.ofNumbers(i, errors);
  for (std::size_t first = 0; first < fragments.size();) {
    std::size_t last = first + 1;
    while (last < fragments.size() && fragments[last].distance - fragments[last - 1].distance <= errors.together)
      ++last;
    if (last - first > 1) sum += moves.ofOrder(first, last);
    if (last - first > 2) sum += moves.ofMissing(first, last);
    first = last;
  }
  return sum;
}

double cutEffect(const RayScene& scene, RayFunction function, std::span<const CellSegment> segments, double distance) {
  std::vector<CellSegment> kept;
  for (CellSegment s : segments) {
    if (s.exit <= distance) continue;
    if (s.entry < distance) {
      const double part = (distance - s.entry) / (s.exit - s.entry);
      s.scalarEntry += part * (s.scalarExit - s.scalarEntry);
      s.entry = distance;
    }
    kept.push_back(s);
  }
  return difference(function(scene, kept), function(scene, segments));
}

}  // namespace havs::test
