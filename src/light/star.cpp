#include "light/star.h"

#include "mesh/face_matching.h"

namespace havs {

std::uint32_t Star::rimPlace(Index point, const Vec3& position) {
  for (std::size_t i = 0; i < rim_.size(); ++i)
    if (rim_[i].point == point) return static_cast<std::uint32_t>(i);
  rim_.push_back({point, position});
  return static_cast<std::uint32_t>(rim_.size() - 1);
}

void Star::gather(Index point, std::span<const Index> around, std::span<const Vec3> points,
                  std::span<const Tetrahedron> cells, const Neighbours& neighbours) {
  point_ = point;
  position_ = points[point];
  inward_ = Vec3(0);
  links_.clear();
  rim_.clear();
  for (const Index c : around) {
    const Tetrahedron& cell = cells[c];
    for (std::size_t i = 0; i < 4; ++i) {
      if (cell[i] == point) {
        const auto [a, b, d] = outwardFace(cell, i);
        links_.push_back(
            {{rimPlace(a, points[a]), rimPlace(b, points[b]), rimPlace(d, points[d])}, c, neighbours[c][i]});
      } else if (neighbours[c][i] == kNoIndex) {
        const auto [a, b, d] = outwardFace(cell, i);
        inward_ -= 0.5 * cross(points[b] - points[a], points[d] - points[a]);
      }
    }
  }
}

Star::Exit Star::leave(const LineFrame& line) {
  seen_.clear();
  for (const RimPoint& p : rim_) seen_.push_back(line.see(p.position, p.point));
  Exit exit;
  for (const Link& link : links_) {
    exit.triangle.corner = {seen_[link.corner[0]], seen_[link.corner[1]], seen_[link.corner[2]]};
    // Behind the point, too, rays go through such faces, but these turn the other way.
    if (!exit.triangle.isHit()) continue;
    exit.cell = link.cell;
    exit.next = link.next;
    return exit;
  }
  return exit;
}

}  // namespace havs
