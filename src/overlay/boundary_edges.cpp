#include "overlay/boundary_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "core/parallel.h"

namespace havs {
namespace {

constexpr std::uint8_t kAll = 7;  // edges, corners

void mark(std::uint8_t& bits, std::size_t which) { bits = static_cast<std::uint8_t>(bits | 1u << which); }

/// An edge as one of its faces has it.
struct EdgeOfFace {
  Index from, to;  ///< from < to
  std::uint32_t face;
  std::uint8_t edge;
  bool sameEdge(const EdgeOfFace& other) const { return from == other.from && to == other.to; }
  bool operator<(const EdgeOfFace& other) const {
    return std::tie(from, to, face, edge) < std::tie(other.from, other.to, other.face, other.edge);
  }
};

std::vector<EdgeOfFace> edgesOf(const std::vector<BoundaryFace>& faces) {
  std::vector<EdgeOfFace> edges(3 * faces.size());
  parallelFor(0, faces.size(), 8192, [&](std::size_t f) {
    for (std::uint8_t e = 0; e < 3; ++e) {
      const auto [low, high] = std::minmax(faces[f].corners[e], faces[f].corners[(e + 1) % 3]);
      edges[3 * f + e] = {low, high, static_cast<std::uint32_t>(f), e};
    }
  });
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Degrees.
double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
}

/// Marks the edges that do not lie between two faces whose normals differ by no more.
void markFeatures(std::vector<BoundaryFace>& faces, double angle) {
  constexpr double kRounding = 1e-6;  // faces of one plane have normals that differ by it
  const std::vector<EdgeOfFace> edges = edgesOf(faces);
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last].sameEdge(edges[first])) ++last;
    const bool smooth = last - first == 2 && angleBetween(faces[edges[first].face].normal,
                                                          faces[edges[first + 1].face].normal) <= angle + kRounding;
    for (std::size_t i = first; i < last && !smooth; ++i) mark(faces[edges[i].face].edges, edges[i].edge);
  }
}

void markEnds(std::vector<BoundaryFace>& faces, std::size_t points) {
  std::vector<bool> ends(points);
  for (const BoundaryFace& face : faces)
    for (std::size_t e = 0; e < 3; ++e)
      if ((face.edges >> e & 1) != 0) ends[face.corners[e]] = ends[face.corners[(e + 1) % 3]] = true;
  for (BoundaryFace& face : faces)
    for (std::size_t i = 0; i < 3; ++i)
      if (ends[face.corners[i]]) mark(face.ends, i);
}

}  // namespace

std::vector<BoundaryFace> boundaryFaces(const PreparedScene& prepared, std::optional<double> featureAngle) {
  std::vector<BoundaryFace> faces;
  faces.reserve(prepared.faces.boundaryCount);
  for (std::size_t f = 0; f < prepared.faces.size(); ++f) {
    if (!prepared.faces.isBoundary(f)) continue;
    const auto& [a, b, c] = prepared.faces.vertices[f];
    BoundaryFace face{{a, b, c}, {}, featureAngle ? std::uint8_t{0} : kAll, featureAngle ? std::uint8_t{0} : kAll};
    const Vec3 across = cross(prepared.points[b] - prepared.points[a], prepared.points[c] - prepared.points[a]);
    if (const double size = length(across); size > 0) face.normal = across / size;
    std::sort(std::begin(face.corners), std::end(face.corners));
    faces.push_back(face);
  }
  if (featureAngle) {
    markFeatures(faces, *featureAngle);
    markEnds(faces, prepared.points.size());
  }
  return faces;
}

}  // namespace havs
