#pragma once
#include "raster/screen_points.h"

namespace havs {

/// Where the ray of a pixel meets a face, by the fill rule of raster/edge_function.h.
struct FaceHit {
  /// 1 or -1 where the ray meets the face before or behind the eye: the sign of its three products; 0 where it does
  /// not.
  int sign = 0;
  /// The corners' shares, up to a common factor of that sign.
  double a = 0, b = 0, c = 0;
};

/// (x, y): the pixel's centre. The corners in the order of their points' numbers, so that all faces and cells at an
/// edge decide alike; width and height bound x and y. Doubles decide where their rounding cannot matter, exact sums
/// elsewhere.
FaceHit hitFace(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c, double x, double y, int width,
                int height);

}  // namespace havs
