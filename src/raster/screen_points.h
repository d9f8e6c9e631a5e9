#pragma once
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "core/vec.h"
#include "scene/view.h"

namespace havs {

/// A point as the picture sees it, in homogeneous coordinates: it lies on the ray of the pixel coordinates (x / w, y /
/// w), also where it is behind the eye.
struct ScreenPoint {
  double x, y;   ///< pixels (x right, y down, centres at halves) times w
  double w;      ///< distance from the eye along the view direction; 1 for parallel rays
  double depth;  ///< along the view direction, relative to the mesh's centre
};

/// All points, in parallel. Each is rounded once; the fill rule (edge_function.h) is exact for what comes out here.
std::vector<ScreenPoint> screenPoints(std::span<const Vec3> localPoints, const View& view);

/// The same of one.
ScreenPoint screenPoint(const Vec3& localPoint, const View& view);

/// On which side of the plane of the points a, b, c the eye lies, as screenPoint has them: 1 where they turn
/// right-handed towards it, -1 where away from it, 0 where they lie on one line of the picture. Exact for what
/// screenPoint gives, so that it is the side that the fill rule's pixels see.
int sideOfEye(const Vec3& a, const Vec3& b, const Vec3& c, const View& view);

/// A rectangle of pixels, both ends included; empty where right < left or bottom < top.
struct PixelBox {
  int left, top, right, bottom;
  bool empty() const { return right < left || bottom < top; }
  double area() const { return empty() ? 0.0 : (right - left + 1.0) * (bottom - top + 1.0); }
};

PixelBox intersection(const PixelBox& a, const PixelBox& b);

/// The pixels of a picture whose rays may meet the tetrahedron of these corners in front of the eye: none that does is
/// left out.
PixelBox boxOf(const std::array<ScreenPoint, 4>& corners, int width, int height);

}  // namespace havs
