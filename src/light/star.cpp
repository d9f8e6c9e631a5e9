#include "light/star.h"

#include "mesh/face_matching.h"

namespace havs {

std::uint32_t Star::rimPlace(Index point, const Node& node) {
  for (std::size_t i = 0; i < rim_.size(); ++i)
    if (rim_[i].point == point) return static_cast<std::uint32_t>(i);
  rim_.push_back({point, node});
  return static_cast<std::uint32_t>(rim_.size() - 1);
}

void Star::gather(Index point, std::span<const Index> around, std::span<const Node> nodes,
                  std::span<const LinkedCell> cells) {
  node_ = nodes[point];
  inward_ = Vec3(0);
  links_.clear();
  rim_.clear();
  for (const Index c : around) {
    const LinkedCell& cell = cells[c];
    for (std::size_t i = 0; i < 4; ++i) {
      const auto [a, b, d] = outwardFace(cell.points, i);
      if (cell.points[i] == point) {
        links_.push_back({{rimPlace(a, nodes[a]), rimPlace(b, nodes[b]), rimPlace(d, nodes[d])}, c, cell.across[i]});
      } else if (cell.across[i] == kNoIndex) {
        const Vec3& corner = nodes[a].position;
        inward_ -= 0.5 * cross(nodes[b].position - corner, nodes[d].position - corner);
      }
    }
  }
}

Star::Exit Star::leave(const LineFrame& line) {
  seen_.clear();
  for (const RimPoint& p : rim_) seen_.push_back(line.see(p.node, p.point));
  for (const Link& link : links_) {
    const LinePoint &a = seen_[link.corner[0]], &b = seen_[link.corner[1]], &c = seen_[link.corner[2]];
    // Behind the point, too, the line goes through such a face, but that turns the other way.
    const LineSide ab = sideOf(a, b);
    if (ab.sign <= 0) continue;
    const LineSide bc = sideOf(b, c);
    if (bc.sign <= 0) continue;
    const LineSide ca = sideOf(c, a);
    if (ca.sign > 0) return {link.cell, link.next, {{a, b, c}, {bc.value, ca.value, ab.value}}};
  }
  return {};
}

}  // namespace havs
