#include "render/gl/tile.h"

#include <algorithm>

namespace havs {
namespace {

/// The eye lies outside the mesh, depth is not tested: only what is as good as behind the eye is clipped. Local units,
/// along the longest ray: a tenth of what is cut off before the eye (scene/eye_cut.h).
constexpr double kNearPlane = 1e-6;

}  // namespace

std::vector<Tile> tilesOf(const View& view, const RenderPlan& plan) {
  std::vector<Tile> tiles;
  for (int y = 0; y < view.height; y += plan.tileHeight)
    for (int x = 0; x < view.width; x += plan.tileWidth)
      tiles.push_back({x, y, std::min(plan.tileWidth, view.width - x), std::min(plan.tileHeight, view.height - y)});
  return tiles;
}

Mat4 clipMatrix(const View& view, const Tile& tile) {
  const double perspective = view.orthographic ? 0.0 : 1.0;
  // Rows of the whole picture's matrix: u and v as in View, and w.
  const Vec4 w{perspective * view.forward, view.orthographic ? 1.0 : -view.depth(view.eye)};
  auto row = [&](const Vec3& axis, double half) { return Vec4{axis / half, -dot(axis, view.center) / half}; };
  const Vec4 u = row(view.right, view.halfWidth), v = row(view.up, view.halfHeight);
  // The tile's middle goes to 0, its half size to 1.
  auto crop = [&](const Vec4& r, double first, double size, double whole) {
    const double middle = (2.0 * first + size) / whole - 1.0;
    return (r - middle * w) * (whole / size);
  };
  const Vec4 z = view.orthographic ? Vec4{0.0} : w - Vec4{0, 0, 0, 2.0 * kNearPlane / view.rayScale(0, 0)};
  return transpose(Mat4{crop(u, tile.x, tile.width, view.width), crop(v, tile.y, tile.height, view.height), z, w});
}

Vec4 pixelToRay(const View& view, const Tile& tile) {
  if (view.orthographic) return Vec4(0.0);
  const double sx = 2.0 * view.halfWidth / view.width, sy = 2.0 * view.halfHeight / view.height;
  return {sx, sy, tile.x * sx - view.halfWidth, tile.y * sy - view.halfHeight};
}

Vec4 pixelToBase(const View& view, const Tile& tile) {
  const double eyeX = dot(view.right, view.center), eyeY = dot(view.up, view.center);
  // A perspective ray has gone -depth(eye) units of depth when it meets that plane.
  const double reach = view.orthographic ? 1.0 : -view.depth(view.eye);
  const double sx = 2.0 * view.halfWidth / view.width, sy = 2.0 * view.halfHeight / view.height;
  return {reach * sx, reach * sy, eyeX + reach * (tile.x * sx - view.halfWidth),
          eyeY + reach * (tile.y * sy - view.halfHeight)};
}

}  // namespace havs
