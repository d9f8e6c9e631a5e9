#pragma once
#include <algorithm>

#include "sort/face_order.h"

namespace havs {

/// A number of order 1 that grows with the distance of a point from the eye (orthographic: with its depth), and keeps
/// its resolution however far the eye is: (|p - e|^2 - |e|^2) / (2 |e|), whose limit for |e| to infinity is the depth.
class DistanceKey {
 public:
  explicit DistanceKey(const ViewPoint& view) {
    if (view.orthographic) {
      along_ = view.direction;
      return;
    }
    const double scale = 1.0 / std::max(length(view.eye), 1.0);
    along_ = -view.eye * scale;
    curvature_ = 0.5 * scale;
  }
  double operator()(const Vec3& p) const { return curvature_ * dot(p, p) + dot(p, along_); }

 private:
  Vec3 along_{0};
  double curvature_ = 0;
};

}  // namespace havs
