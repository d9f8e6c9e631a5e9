#pragma once
// Cameras on a way through a mesh: from outside, through three of its cells, and out again.
#include <array>
#include <vector>

#include "scene/prepared_scene.h"

namespace havs::test {

/// `count` cameras along a smooth curve (Catmull and Rom 1974) from a place outside the bounding sphere through the
/// centres of three cells to one on the other side, looking ahead and slowly turning aside. Cells lie in space as they
/// do in memory, so the three are far apart, and on the way between them the curve may leave the mesh and enter it.
inline std::vector<Camera> flyPath(const PreparedScene& prepared, int count, double fieldOfView = 60) {
  const auto& cells = prepared.mesh.tetrahedra;
  const auto centre = [&](double share) {
    const auto& [a, b, c, d] = cells[static_cast<std::size_t>(share * static_cast<double>(cells.size() - 1))];
    const auto& p = prepared.points;
    return 0.25 * (p[a] + p[b] + p[c] + p[d]);
  };
  const Vec3 first = centre(0.15), middle = centre(0.5), last = centre(0.9);
  const Vec3 before = 1.6 * normalize(first + Vec3{0.02, 0.05, 0.01}),
             behind = 1.6 * normalize(last + Vec3{0.01, 0.02, 0.05});
  const std::array<Vec3, 7> knots{2.0 * before, before, first, middle, last, behind, 2.0 * behind};
  const auto at = [&](double t) {  // of [0, 1]
    const double along = 4 * t;
    const auto i = std::min(static_cast<std::size_t>(along), std::size_t{3});
    const double s = along - static_cast<double>(i);
    const Vec3 &p0 = knots[i], &p1 = knots[i + 1], &p2 = knots[i + 2], &p3 = knots[i + 3];
    return 0.5 * (2.0 * p1 + (p2 - p0) * s + (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3) * s * s +
                  (3.0 * p1 - p0 - 3.0 * p2 + p3) * s * s * s);
  };
  std::vector<Camera> cameras;
  for (int i = 0; i < count; ++i) {
    const double t = (i + 0.5) / count;
    const Vec3 eye = at(t), ahead = at(std::min(1.0, t + 0.02)) - at(std::max(0.0, t - 0.02));
    const Vec3 aside{std::sin(5 * t), std::cos(4 * t), std::sin(3 * t)};
    Camera camera;
    camera.fieldOfView = fieldOfView;
    camera.eye = prepared.frame.center + prepared.frame.radius * eye;
    camera.target = *camera.eye + prepared.frame.radius * (normalize(ahead) + 0.6 * t * (1 - t) * 4 * aside);
    cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace havs::test
