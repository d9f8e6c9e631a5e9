// A ray meets none or two of a cell's four faces: those whose three edges it passes on the same side (edge_function.h).
// Corners are taken in the order of their numbers, so that the cells on both sides of a face compute its depth and
// scalar from the same numbers in the same order: one cell ends where the next begins, to the last bit.
#include "reference/cell_segments.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "raster/edge_function.h"

namespace havs {
namespace {

/// Edges of a cell by their corners, and faces: face f lies opposite to corner f. `edge` are those opposite to its
/// corners, in their order; the one between the outer two runs against the face's sense.
constexpr int kEdges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
struct FaceTable {
  int corner[3];
  int edge[3];
};
constexpr FaceTable kFaces[4] = {
    {{1, 2, 3}, {5, 4, 3}}, {{0, 2, 3}, {5, 2, 1}}, {{0, 1, 3}, {4, 2, 0}}, {{0, 1, 2}, {3, 1, 0}}};

/// The two faces that a ray meets, by the signs of its six products (bit e: product e is positive); -1: none.
struct FacePair {
  signed char first = -1, second = -1;
};
constexpr std::array<FacePair, 64> makeFacePairs() {
  std::array<FacePair, 64> pairs{};
  for (int bits = 0; bits < 64; ++bits) {
    auto positive = [bits](int edge) { return (bits >> edge & 1) != 0; };
    int met = 0;
    FacePair pair;
    for (int f = 0; f < 4; ++f) {
      const auto& edge = kFaces[f].edge;
      if (positive(edge[0]) != positive(edge[2]) || positive(edge[0]) == positive(edge[1])) continue;
      (met++ == 0 ? pair.first : pair.second) = static_cast<signed char>(f);
    }
    if (met == 2) pairs[static_cast<std::size_t>(bits)] = pair;
  }
  return pairs;
}
constexpr std::array<FacePair, 64> kFacePairs = makeFacePairs();

/// Where a ray meets the plane of a face.
struct Hit {
  double depth, scalar, w;
};

}  // namespace

struct SegmentCollector::Cell {
  Index number;
  bool crossesEyePlane = false;
  std::array<ScreenPoint, 4> corner;
  std::array<double, 4> scalar;
  std::array<double, 6> limit;

  Cell(const ScreenMesh& mesh, Index c) : number(c) {
    Tetrahedron points = mesh.cells[c];
    std::sort(points.begin(), points.end());
    for (std::size_t i = 0; i < 4; ++i) {
      corner[i] = mesh.points[points[i]];
      scalar[i] = mesh.scalars[mesh.cellData ? c : points[i]];
      crossesEyePlane |= !(corner[i].w > 0);
    }
    for (std::size_t e = 0; e < 6; ++e)
      limit[e] = edgeLimit(corner[kEdges[e][0]], corner[kEdges[e][1]], mesh.width, mesh.height);
  }

  /// The products are of one sign, so that the means lie between the values at the corners, up to rounding; the scalar
  /// is kept there, so that a ray in a region of one value does not waver about an isosurface of that value.
  Hit meet(int face, const std::array<double, 6>& products) const {
    const auto& [corners, edges] = kFaces[face];
    const double wa = products[edges[0]], wb = -products[edges[1]], wc = products[edges[2]];
    const auto [i, j, k] = corners;
    const double scale = 1 / (wa + wb + wc);
    auto mean = [&](double a, double b, double c) { return (wa * a + wb * b + wc * c) * scale; };
    const auto [low, high] = std::minmax({scalar[i], scalar[j], scalar[k]});
    Hit hit{mean(corner[i].depth, corner[j].depth, corner[k].depth),
            std::clamp(mean(scalar[i], scalar[j], scalar[k]), low, high), 1};
    if (crossesEyePlane) hit.w = mean(corner[i].w, corner[j].w, corner[k].w);
    return hit;
  }

  /// Where the eye lies on one of the edges without sides (EdgeSide::sign is 0).
  std::optional<double> scalarAtEye(const std::array<int, 6>& signs) const {
    for (std::size_t e = 0; e < 6; ++e) {
      if (signs[e] != 0) continue;
      const auto from = static_cast<std::size_t>(kEdges[e][0]), to = static_cast<std::size_t>(kEdges[e][1]);
      const ScreenPoint &a = corner[from], &b = corner[to];
      const std::array<double, 3> along{a.x - b.x, a.y - b.y, a.w - b.w}, at{a.x, a.y, a.w};
      const auto longest = static_cast<std::size_t>(
          std::max_element(along.begin(), along.end(), [](double p, double q) { return std::abs(p) < std::abs(q); }) -
          along.begin());
      const double share = at[longest] / along[longest];
      if (share >= 0 && share <= 1) return scalar[from] + share * (scalar[to] - scalar[from]);
    }
    return std::nullopt;
  }
};

void SegmentCollector::reset(const PixelBox& rectangle) {
  rectangle_ = rectangle;
  found_.clear();
  grouped_ = false;
}

void SegmentCollector::add(Index number, const PixelBox& box) {
  const PixelBox part = intersection(box, rectangle_);
  if (part.empty()) return;
  const Cell cell(mesh_, number);
  const auto& c = cell.corner;
  for (int row = part.top; row <= part.bottom; ++row) {
    const double y = row + 0.5;
    const double y0 = c[0].y - y * c[0].w, y1 = c[1].y - y * c[1].w, y2 = c[2].y - y * c[2].w, y3 = c[3].y - y * c[3].w;
    for (int column = part.left; column <= part.right; ++column) {
      const double x = column + 0.5;
      const double x0 = c[0].x - x * c[0].w, x1 = c[1].x - x * c[1].w, x2 = c[2].x - x * c[2].w,
                   x3 = c[3].x - x * c[3].w;
      addAt(cell,
            {x0 * y1 - y0 * x1, x0 * y2 - y0 * x2, x0 * y3 - y0 * x3, x1 * y2 - y1 * x2, x1 * y3 - y1 * x3,
             x2 * y3 - y2 * x3},
            column, row);
    }
  }
}

inline void SegmentCollector::addAt(const Cell& cell, const std::array<double, 6>& products, int x, int y) {
  bool certain = true;
  unsigned bits = 0;
  for (unsigned e = 0; e < 6; ++e) {
    certain &= std::abs(products[e]) > cell.limit[e];
    bits |= static_cast<unsigned>(products[e] > 0) << e;
  }
  if (!certain) return addExactlyAt(cell, x, y);
  const FacePair pair = kFacePairs[bits];
  if (pair.first >= 0) addFaces(cell, products, pair.first, pair.second, x, y);
}

void SegmentCollector::addExactlyAt(const Cell& cell, int column, int row) {
  const double x = column + 0.5, y = row + 0.5;
  std::array<double, 6> products;
  std::array<int, 6> signs;
  for (std::size_t e = 0; e < 6; ++e) {
    const ScreenPoint &a = cell.corner[kEdges[e][0]], &b = cell.corner[kEdges[e][1]];
    products[e] = (a.x - x * a.w) * (b.y - y * b.w) - (a.y - y * a.w) * (b.x - x * b.w);
    signs[e] = products[e] > 0 ? 1 : -1;
    if (std::abs(products[e]) > cell.limit[e]) continue;
    const EdgeSide side = exactEdgeSide(a, b, x, y);
    products[e] = side.value;
    signs[e] = side.sign;
  }
  std::array<int, 4> met{};
  std::size_t count = 0;
  for (int f = 0; f < 4; ++f) {
    const auto& edge = kFaces[f].edge;
    const int sign = signs[static_cast<std::size_t>(edge[0])];
    if (sign != 0 && sign == -signs[static_cast<std::size_t>(edge[1])] &&
        sign == signs[static_cast<std::size_t>(edge[2])])
      met[count++] = f;
  }
  if (count == 2) addFaces(cell, products, met[0], met[1], column, row);
  if (count == 1) addFromEye(cell, products, signs, met[0], column, row);
}

/// The eye lies on an edge or a corner of the cell, so that faces there have no sides: the ray starts in the cell, or
/// is not in it before the eye, and leaves it by the other face.
void SegmentCollector::addFromEye(const Cell& cell, const std::array<double, 6>& products,
                                  const std::array<int, 6>& signs, int face, int x, int y) {
  const std::optional<double> scalar = cell.scalarAtEye(signs);
  const Hit back = cell.meet(face, products);
  if (scalar && back.w > 0 && std::isfinite(back.depth))
    add({mesh_.eyeDepth, back.depth, *scalar, back.scalar, cell.number}, x, y);
}

void SegmentCollector::addFaces(const Cell& cell, const std::array<double, 6>& products, int first, int second, int x,
                                int y) {
  Hit front = cell.meet(first, products), back = cell.meet(second, products);
  if (!std::isfinite(front.depth + back.depth)) return;  // an eye in the plane of a face
  if (back.depth < front.depth) std::swap(front, back);
  if (cell.crossesEyePlane) {
    if (!(back.w > 0)) return;
    if (!(front.w > 0)) {  // the eye is in the cell
      const double share = back.w / (back.w - front.w);
      front.scalar = back.scalar + share * (front.scalar - back.scalar);
      front.depth = mesh_.eyeDepth;
    }
  }
  add({front.depth, back.depth, front.scalar, back.scalar, cell.number}, x, y);
}

void SegmentCollector::add(const CellSegment& segment, int x, int y) {
  const int columns = rectangle_.right - rectangle_.left + 1;
  found_.push_back({segment, static_cast<std::uint32_t>((y - rectangle_.top) * columns + x - rectangle_.left)});
}

void SegmentCollector::groupByPixel() {
  const auto pixels = static_cast<std::size_t>(rectangle_.area());
  begin_.assign(pixels + 2, 0);
  for (const Found& f : found_) ++begin_[f.pixel + 2];
  for (std::size_t i = 2; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  segments_.resize(found_.size());
  for (const Found& f : found_) segments_[begin_[f.pixel + 1]++] = f.segment;
  grouped_ = true;
}

std::span<const CellSegment> SegmentCollector::at(int x, int y, double rayScale) {
  if (!grouped_) groupByPixel();
  const auto pixel =
      static_cast<std::size_t>((y - rectangle_.top) * (rectangle_.right - rectangle_.left + 1) + x - rectangle_.left);
  const auto first = segments_.begin() + begin_[pixel], last = segments_.begin() + begin_[pixel + 1];
  std::sort(first, last, [](const CellSegment& a, const CellSegment& b) {
    if (a.entry != b.entry) return a.entry < b.entry;
    return a.exit != b.exit ? a.exit < b.exit : a.cell < b.cell;
  });
  settled_.clear();
  double reached = -std::numeric_limits<double>::infinity();
  for (auto segment = first; segment != last; ++segment) {
    CellSegment s = *segment;
    s.entry *= rayScale;
    s.exit *= rayScale;
    if (s.entry < reached) {
      if (!(s.exit > reached)) continue;
      s.scalarEntry += (reached - s.entry) / (s.exit - s.entry) * (s.scalarExit - s.scalarEntry);
      s.entry = reached;
    }
    reached = s.exit;
    settled_.push_back(s);
  }
  return settled_;
}

}  // namespace havs
