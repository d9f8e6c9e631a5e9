#pragma once
#include "core/vec.h"

namespace havs {

/// A camera as the drawing sees it: in the local frame, for one picture size. Made by makeView (scene/camera.h), in
/// double. A ray through the pixel centre (x + 0.5, y + 0.5), y down from the top, has
///   u = 2 (x + 0.5) / width - 1, v = 1 - 2 (y + 0.5) / height;
/// perspective: from eye along forward + u * halfWidth * right + v * halfHeight * up (not normalised: its forward part
/// is 1); orthographic: from center + u * halfWidth * right + v * halfHeight * up along forward.
struct View {
  bool orthographic = false;
  int width = 0;
  int height = 0;
  Vec3 eye{0};      ///< perspective only
  Vec3 center{0};   ///< on the axis (what the picture's middle shows): the eye or the target (axisPoint, camera.cpp)
  Vec3 forward{0};  ///< right, up, forward: orthonormal, right-handed as right x up = -forward
  Vec3 right{0};
  Vec3 up{0};
  double halfWidth = 1;   ///< tangent of half the horizontal angle; orthographic: half the width in local units
  double halfHeight = 1;  ///< the same for the vertical

  /// Depth relative to the origin of the local frame (the mesh's centre), along `forward`: the same for every camera
  /// distance.
  double depth(const Vec3& p) const { return dot(forward, p); }
  /// Pixel coordinates (x right, y down, pixel centres at halves) of a point in front of the eye; z: distance along
  /// forward from the eye (perspective) or depth (orthographic).
  Vec3 project(const Vec3& p) const;
  /// Length along the pixel's ray for one unit of depth: 1 for orthographic, else 1 / cos of the ray's angle to
  /// forward.
  double rayScale(double pixelX, double pixelY) const;
};

}  // namespace havs
