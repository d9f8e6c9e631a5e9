#include "overlay/boundary_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "core/parallel.h"

namespace havs {
namespace {

std::vector<EdgeOfFace> edgesOf(const std::vector<BoundaryFace>& faces) {
  std::vector<EdgeOfFace> edges(3 * faces.size());
  parallelFor(0, faces.size(), 8192, [&](std::size_t f) {
    const auto& [a, b, c] = faces[f].corners;
    const auto face = static_cast<std::uint32_t>(f);
    edges[3 * f] = {a, b, face};
    edges[3 * f + 1] = {b, c, face};
    edges[3 * f + 2] = {a, c, face};
  });
  std::sort(edges.begin(), edges.end(), [](const EdgeOfFace& a, const EdgeOfFace& b) {
    return std::tie(a.from, a.to, a.face) < std::tie(b.from, b.to, b.face);
  });
  return edges;
}

/// Degrees.
double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
}

}  // namespace

std::vector<BoundaryFace> boundaryFaces(const PreparedScene& prepared) {
  std::vector<BoundaryFace> faces;
  faces.reserve(prepared.faces.boundaryCount);
  for (std::size_t f = 0; f < prepared.faces.size(); ++f) {
    if (!prepared.faces.isBoundary(f)) continue;
    const auto& [a, b, c] = prepared.faces.vertices[f];
    BoundaryFace face{{a, b, c}, Vec3{0}};
    const Vec3 across = cross(prepared.points[b] - prepared.points[a], prepared.points[c] - prepared.points[a]);
    if (const double size = length(across); size > 0) face.normal = across / size;
    std::sort(std::begin(face.corners), std::end(face.corners));
    faces.push_back(face);
  }
  return faces;
}

FeatureEdges::FeatureEdges(const std::vector<BoundaryFace>& faces, std::size_t points, double angle) {
  constexpr double kRounding = 1e-6;  // faces of one plane have normals that differ by it
  const std::vector<EdgeOfFace> edges = edgesOf(faces);
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last].sameEdge(edges[first])) ++last;
    const bool smooth = last - first == 2 && angleBetween(faces[edges[first].face].normal,
                                                          faces[edges[first + 1].face].normal) <= angle + kRounding;
    if (!smooth) edges_.insert(edges_.end(), &edges[first], &edges[first] + (last - first));
  }
  begin_.assign(points + 2, 0);
  for (const EdgeOfFace& edge : edges_)
    for (const Index point : {edge.from, edge.to}) ++begin_[point + 2];
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  ofPoints_.resize(begin_.back());
  for (std::size_t e = 0; e < edges_.size(); ++e)
    for (const Index point : {edges_[e].from, edges_[e].to})
      ofPoints_[begin_[point + 1]++] = static_cast<std::uint32_t>(e);
}

}  // namespace havs
