#include "mesh/cell_quality.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace havs {
namespace {

double largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Right for all but cells near flatness and numbers near overflow or underflow, of which it knows nothing; false for
/// what is not finite. The volume's rounding error is below 1e-14 of the product of the edges.
bool isClearlySound(const std::array<Vec3, 4>& p) {
  const Vec3 a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0];
  const double longestSquared = std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(c, c)});
  const double volume = glm::dot(glm::cross(a, b), c);
  return longestSquared > 1e-60 && longestSquared < 1e60 && volume > 1e-12 * longestSquared * std::sqrt(longestSquared);
}

CellState stateOf(const std::vector<Vec3>& points, const Tetrahedron& t) {
  const std::array<Vec3, 4> p = {points[t[0]], points[t[1]], points[t[2]], points[t[3]]};
  if (isClearlySound(p)) return CellState::sound;
  if (!std::all_of(p.begin(), p.end(), isFinite)) return CellState::notFinite;
  // Halved before subtracting and then divided by the largest component, so that nothing overflows or vanishes.
  Vec3 a = 0.5 * p[1] - 0.5 * p[0];
  Vec3 b = 0.5 * p[2] - 0.5 * p[0];
  Vec3 c = 0.5 * p[3] - 0.5 * p[0];
  const double size = std::max({largest(a), largest(b), largest(c)});
  if (size == 0) return CellState::flat;
  a /= size;
  b /= size;
  c /= size;
  const double longestSquared = std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(c, c), glm::dot(b - a, b - a),
                                          glm::dot(c - a, c - a), glm::dot(c - b, c - b)});
  const double volume = glm::dot(glm::cross(a, b), c) / 6;
  if (std::abs(volume) <= 1e-15 * longestSquared * std::sqrt(longestSquared)) return CellState::flat;
  return volume > 0 ? CellState::sound : CellState::inverted;
}

}  // namespace

std::vector<CellState> cellStates(const TetMesh& mesh) {
  std::vector<CellState> states(mesh.tetrahedra.size());
  parallelFor(0, states.size(), 4096, [&](std::size_t i) { states[i] = stateOf(mesh.points, mesh.tetrahedra[i]); });
  return states;
}

}  // namespace havs
