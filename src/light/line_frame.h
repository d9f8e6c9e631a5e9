#pragma once
// A ray seen along itself: points become points of a plane, the ray its origin, and a triangle is hit where it contains
// the origin. For the signs by which that is decided the points' plane coordinates count as exact, so that all faces
// and cells at an edge decide alike (as in raster/edge_function.h, for pixels).
#include <algorithm>
#include <cmath>

#include "core/vec.h"
#include "mesh/tet_mesh.h"

namespace havs {

/// A point of the mesh as a ray sees it: across the ray, and along it.
struct LinePoint {
  double x, y;    ///< across
  double along;   ///< distance from the ray's start
  double scalar;  ///< of point data
  Index point;
};

/// A point of the mesh with its scalar (0 of cell data): what a ray reads of it lies in one place.
struct Node {
  Vec3 position;
  double scalar;
};

/// On which side of the edge from a to b the ray passes.
struct LineSide {
  double value;  ///< a.x b.y - a.y b.x to the last digits
  /// 1 where the ray has the edge turning right-handed about its direction, -1 where left-handed. The ray counts as
  /// moved by an infinitesimal (e, e^2) across, so that it misses every edge. 0: both ends lie on one parallel of it.
  int sign;
};

class LineFrame {
 public:
  static constexpr double kTurn = 1e-12;

  /// `direction` of length 1, turned by kTurn towards `aside` (of any length; 0 or along the ray: not turned): more
  /// than the rounding of points that lie in one plane with the ray.
  LineFrame(const Vec3& start, const Vec3& direction, const Vec3& aside) : start_(start), direction_(direction) {
    Vec3 across = aside - dot(aside, direction) * direction;
    double squared = dot(across, across), turn = kTurn;
    if (!(squared > 1e-12 * dot(aside, aside))) {
      turn = 0;
      Vec3 axis{0};
      const Vec3 a = abs(direction);
      axis[a.x <= a.y && a.x <= a.z ? 0 : a.y <= a.z ? 1 : 2] = 1;
      across = axis - dot(axis, direction) * direction;
      squared = dot(across, across);
    }
    x_ = across / std::sqrt(squared);
    y_ = cross(direction, x_);
    direction_ += turn * x_;
    x_ -= turn * direction;
  }

  const Vec3& start() const { return start_; }
  const Vec3& direction() const { return direction_; }
  LinePoint see(const Node& node, Index point) const {
    const Vec3 r = node.position - start_;
    return {flushed(dot(x_, r)), flushed(dot(y_, r)), dot(direction_, r), node.scalar, point};
  }

 private:
  /// So that no product of two coordinates underflows.
  static double flushed(double value) { return std::abs(value) < 1e-100 ? 0.0 : value; }
  Vec3 start_, direction_, x_, y_;
};

namespace detail {
LineSide closeSide(const LinePoint& a, const LinePoint& b, double product);
}

/// A product rounds without changing its place among others, so that rounded products that differ tell the sign.
inline LineSide sideOf(const LinePoint& a, const LinePoint& b) {
  const double p = a.x * b.y, q = a.y * b.x;
  if (p == q) return detail::closeSide(a, b, p);
  return {p - q, p > q ? 1 : -1};
}

}  // namespace havs
