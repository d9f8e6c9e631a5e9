#pragma once
// The fill rule: on which side of an edge of the mesh a pixel's ray passes.
//
// With the ends a and b of the edge and the ray of pixel (x, y), the triple product of the three directions is
//   (ax - x aw)(by - y bw) - (ay - y aw)(bx - x bw);
// its sign says on which side the ray passes, whether the ends lie before or behind the eye. The products of the three
// edges of a face are the weights, up to a common factor, with which its corners make up the point where the ray meets
// its plane. Doubles decide the sign where their rounding cannot matter, exact sums elsewhere.
#include "raster/screen_points.h"

namespace havs {

struct EdgeSide {
  double value;  ///< the triple product, to the last bits; its sign is exact
  /// 1 or -1: the sign of the triple product. A ray that meets the line of the edge counts as moved by an infinitesimal
  /// (e, e^2) pixels. So it passes on one side of every edge, and of the cells around an edge or a point it goes
  /// through those that a ray beside it goes through. 0: the ends lie on one ray, the edge has no sides.
  int sign;
};

/// A triple product computed in doubles, as it stands above, whose magnitude exceeds this has the right sign and an
/// error of at most 2^-20 of itself: for all pixels with x <= width and y <= height.
double edgeLimit(const ScreenPoint& a, const ScreenPoint& b, int width, int height);

/// In exact arithmetic. The same bits for all cells at the edge, if they give its ends in the same order.
EdgeSide exactEdgeSide(const ScreenPoint& a, const ScreenPoint& b, double x, double y);

}  // namespace havs
