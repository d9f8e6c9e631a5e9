#include "raster/face_hit.h"

#include <cmath>

#include "raster/edge_function.h"

namespace havs {
namespace {

EdgeSide edgeSide(const ScreenPoint& a, const ScreenPoint& b, double x, double y, int width, int height) {
  const double value = (a.x - x * a.w) * (b.y - y * b.w) - (a.y - y * a.w) * (b.x - x * b.w);
  if (std::abs(value) > edgeLimit(a, b, width, height)) return {value, value > 0 ? 1 : -1};
  return exactEdgeSide(a, b, x, y);
}

}  // namespace

FaceHit hitFace(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c, double x, double y, int width,
                int height) {
  const EdgeSide ofA = edgeSide(b, c, x, y, width, height);
  const EdgeSide ofB = edgeSide(a, c, x, y, width, height);  // runs against the sense of the others
  if (ofA.sign == 0 || ofA.sign == ofB.sign) return {};
  const EdgeSide ofC = edgeSide(a, b, x, y, width, height);
  if (ofA.sign != ofC.sign || ofB.sign == 0) return {};
  return {ofA.sign, ofA.value, -ofB.value, ofC.value};
}

}  // namespace havs
