#include "mesh/cell_cutter.h"

#include <algorithm>

namespace havs {
namespace {

bool hasRepeats(const Tetrahedron& t) {
  return t[0] == t[1] || t[0] == t[2] || t[0] == t[3] || t[1] == t[2] || t[1] == t[3] || t[2] == t[3];
}

bool hasRepeats(std::span<const Index> numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (std::size_t j = i + 1; j < numbers.size(); ++j)
      if (numbers[i] == numbers[j]) return true;
  return false;
}

bool contains(const std::array<Index, 3>& triangle, Index point) {
  return triangle[0] == point || triangle[1] == point || triangle[2] == point;
}

/// The triangle rotated so that `point` comes first.
std::array<Index, 3> startingAt(Index point, const std::array<Index, 3>& t) {
  if (t[0] == point) return t;
  return t[1] == point ? std::array{t[1], t[2], t[0]} : std::array{t[2], t[0], t[1]};
}

double sixVolumes(const std::vector<Vec3>& points, const Tetrahedron& t) {
  const Vec3 origin = points[t[0]];
  return glm::dot(glm::cross(points[t[1]] - origin, points[t[2]] - origin), points[t[3]] - origin);
}

}  // namespace

void CellCutter::cut(Index cell, const CellShape& shape, std::span<const Index> corners) {
  cell_ = cell;
  droppedPiece_ = false;
  const std::size_t before = tetrahedra_.size();
  switch (shape.rule) {
    case CutRule::keep:  // as it is: inspectMesh counts it if it is flat
      tetrahedra_.push_back({corners[0], corners[1], corners[2], corners[3]});
      sourceCells_.push_back(cell_);
      break;
    case CutRule::fromLowestPoint:
      cutFromLowestPoint(shape, corners);
      break;
    case CutRule::fromCentre:
      cutFromCentre(shape, corners);
      break;
    case CutRule::quadraticTetra:
      cutQuadraticTetra(corners);
      break;
    default:
      return;
  }
  degenerateCells_ += droppedPiece_ ? 1 : 0;
  collapsedCells_ += tetrahedra_.size() == before ? 1 : 0;
}

void CellCutter::cutFromLowestPoint(const CellShape& shape, std::span<const Index> corners) {
  gatherSurface(shape, corners);
  const auto lowestAt = std::min_element(corners.begin(), corners.end()) - corners.begin();
  const Index lowest = corners[static_cast<std::size_t>(lowestAt)];
  droppedPiece_ = hasRepeats(corners);

  // The corner across the body diagonal: 8 points as a hexahedron or a voxel numbers them.
  constexpr std::array<std::size_t, 8> kAcrossHexahedron = {6, 7, 4, 5, 2, 3, 0, 1};
  const bool isVoxel = &shape == &cellShape(11);
  if (corners.size() == 8 && !droppedPiece_) {
    const auto at = static_cast<std::size_t>(lowestAt);
    replaceThreeByTwo(lowest, corners[isVoxel ? 7 - at : kAcrossHexahedron[at]]);
  }
  for (const Triangle& t : surface_)
    if (!contains(t, lowest)) add({lowest, t[0], t[1], t[2]});
}

/// When no face's diagonal ends in `opposite`, three tetrahedra of the cone share the edge from `lowest` to it; the
/// corner tetrahedron of `opposite` and one in the middle take their place: the hexahedron's cut in five.
bool CellCutter::replaceThreeByTwo(Index lowest, Index opposite) {
  const auto touching =
      std::partition(surface_.begin(), surface_.end(), [&](const Triangle& t) { return !contains(t, opposite); });
  if (surface_.end() - touching != 3) return false;
  const Triangle first = startingAt(opposite, touching[0]);
  const Triangle second = startingAt(opposite, touching[1]);
  const Index a = first[1];
  const Index b = first[2];
  const Index c = second[1] == b ? second[2] : second[1];
  surface_.erase(touching, surface_.end());
  add({lowest, a, b, c});
  add({a, b, c, opposite});
  return true;
}

void CellCutter::cutFromCentre(const CellShape& shape, std::span<const Index> corners) {
  gatherSurface(shape, corners);
  const Index centre = shape.centreNode >= 0 ? corners[static_cast<std::size_t>(shape.centreNode)]
                                             : addCentre({corners.begin(), corners.end()});
  for (const Triangle& t : surface_) add({centre, t[0], t[1], t[2]});
}

/// Mid nodes in VTK's order: 4 on edge 01, 5 on 12, 6 on 02, 7 on 03, 8 on 13, 9 on 23. The octahedron between them is
/// cut at its shortest diagonal, inside the cell, where no neighbour sees it.
void CellCutter::cutQuadraticTetra(std::span<const Index> p) {
  add({p[0], p[4], p[6], p[7]});
  add({p[4], p[1], p[5], p[8]});
  add({p[6], p[5], p[2], p[9]});
  add({p[7], p[8], p[9], p[3]});
  struct Diagonal {
    int from, to;
    std::array<int, 4> ring;
  };
  constexpr std::array<Diagonal, 3> kDiagonals = {{{4, 9, {5, 6, 7, 8}}, {5, 7, {6, 4, 8, 9}}, {6, 8, {4, 5, 9, 7}}}};
  const auto at = [&](int i) { return p[static_cast<std::size_t>(i)]; };
  const auto length = [&](const Diagonal& d) { return glm::length(points_[at(d.to)] - points_[at(d.from)]); };
  const Diagonal& shortest = *std::min_element(kDiagonals.begin(), kDiagonals.end(),
                                               [&](const auto& a, const auto& b) { return length(a) < length(b); });
  for (std::size_t i = 0; i < 4; ++i)
    add({at(shortest.from), at(shortest.to), at(shortest.ring[i]), at(shortest.ring[(i + 1) % 4])});
}

void CellCutter::cutPolyhedron(Index cell, std::span<const Index> stream) {
  cell_ = cell;
  droppedPiece_ = false;
  surface_.clear();
  const std::size_t before = tetrahedra_.size();
  std::vector<Index> corners;
  for (std::size_t at = 1; at < stream.size(); at += stream[at] + 1) {
    const auto face = stream.subspan(at + 1, stream[at]);
    fan(face);
    corners.insert(corners.end(), face.begin(), face.end());
  }
  const Index centre = addCentre(std::move(corners));
  for (const Triangle& t : surface_) {
    Tetrahedron tetrahedron = {centre, t[0], t[1], t[2]};
    // The faces of a polyhedron may be turned either way.
    if (sixVolumes(points_, tetrahedron) < 0) std::swap(tetrahedron[2], tetrahedron[3]);
    add(tetrahedron);
  }
  degenerateCells_ += droppedPiece_ ? 1 : 0;
  collapsedCells_ += tetrahedra_.size() == before ? 1 : 0;
}

void CellCutter::gatherSurface(const CellShape& shape, std::span<const Index> corners) {
  surface_.clear();
  std::array<Index, 8> polygon;
  for (const auto& facet : shape.facets) {
    std::transform(facet.begin(), facet.end(), polygon.begin(), [&](std::uint8_t i) { return corners[i]; });
    fan({polygon.data(), facet.size()});
  }
}

void CellCutter::fan(std::span<const Index> polygon) {
  const std::size_t n = polygon.size();
  const auto start = static_cast<std::size_t>(std::min_element(polygon.begin(), polygon.end()) - polygon.begin());
  for (std::size_t i = 1; i + 1 < n; ++i)
    surface_.push_back({polygon[start], polygon[(start + i) % n], polygon[(start + i + 1) % n]});
}

void CellCutter::add(const Tetrahedron& tetrahedron) {
  if (hasRepeats(tetrahedron)) {
    droppedPiece_ = true;
    return;
  }
  tetrahedra_.push_back(tetrahedron);
  sourceCells_.push_back(cell_);
}

Index CellCutter::addCentre(std::vector<Index> around) {
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  const double weight = 1.0 / static_cast<double>(around.size());
  Vec3 mean(0);
  for (const Index point : around) mean += weight * points_[point];
  points_.push_back(mean);
  for (Field& field : pointFields_) {
    const auto n = static_cast<std::size_t>(field.components);
    for (std::size_t c = 0; c < n; ++c) {
      double value = 0;
      for (const Index point : around) value += weight * field.values[point * n + c];
      field.values.push_back(value);
    }
  }
  return static_cast<Index>(points_.size() - 1);
}

}  // namespace havs
