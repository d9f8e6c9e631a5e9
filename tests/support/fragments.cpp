// Coverage by the side of the pixel's centre on which each edge passes. The side of an edge is computed from its two ends in an order
// that depends on their positions only, so all faces at an edge agree about it; a centre on the edge counts as moved by an
// infinitesimal (e, e^2). Every ray through a closed surface then meets as many front as back faces.
#include "support/fragments.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/parallel.h"

namespace havs::test {
namespace {

/// Twice the signed area of (a, b, p) with a before b in (x, y); and the side that p, moved by (e, e^2), is on.
struct Edge {
  double value;
  bool left;
};

Edge orderedEdge(const Vec3& a, const Vec3& b, double x, double y) {
  const double value = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
  if (value != 0) return {value, value > 0};
  return {0, b.y != a.y ? b.y < a.y : b.x > a.x};
}

Edge edge(const Vec3& a, const Vec3& b, double x, double y) {
  if (std::pair(a.x, a.y) <= std::pair(b.x, b.y)) return orderedEdge(a, b, x, y);
  const Edge reversed = orderedEdge(b, a, x, y);
  return {-reversed.value, !reversed.left};
}

}  // namespace

FragmentSource::FragmentSource(std::span<const Vec3> points, const Faces& faces, std::span<const Index> order,
                               std::span<const double> scalars, const View& view)
    : faces_(faces),
      scalars_(scalars),
      view_(view),
      projected_(points.size()),
      depths_(points.size()),
      tilesX_((view.width + kTileSize - 1) / kTileSize),
      tilesY_((view.height + kTileSize - 1) / kTileSize) {
  parallelFor(0, points.size(), 4096, [&](std::size_t i) {
    projected_[i] = view.project(points[i]);
    depths_[i] = view.depth(points[i]);
  });
  if (!view.orthographic)
    for (const auto& vertices : faces.vertices)
      for (const Index v : vertices)
        if (!(projected_[v].z > 0)) throw std::invalid_argument("a point behind the eye cannot be replayed");
  binFaces(order);
}

FragmentSource::PixelBox FragmentSource::boxOf(Index face) const {
  const auto& [i, j, k] = faces_.vertices[face];
  const Vec3 &a = projected_[i], &b = projected_[j], &c = projected_[k];
  auto firstCentre = [](double low) { return static_cast<int>(std::ceil(std::clamp(low, -1.0, 1e9) - 0.5)); };
  auto lastCentre = [](double high) { return static_cast<int>(std::floor(std::clamp(high, -1.0, 1e9) - 0.5)); };
  return {std::max(0, firstCentre(std::min({a.x, b.x, c.x}))), std::max(0, firstCentre(std::min({a.y, b.y, c.y}))),
          std::min(view_.width - 1, lastCentre(std::max({a.x, b.x, c.x}))),
          std::min(view_.height - 1, lastCentre(std::max({a.y, b.y, c.y})))};
}

void FragmentSource::binFaces(std::span<const Index> order) {
  auto forEachTile = [&](Index face, const auto& visit) {
    const PixelBox pixels = boxOf(face);
    if (pixels.right < pixels.left || pixels.bottom < pixels.top) return;
    for (int y = pixels.top / kTileSize; y <= pixels.bottom / kTileSize; ++y)
      for (int x = pixels.left / kTileSize; x <= pixels.right / kTileSize; ++x)
        visit(static_cast<std::size_t>(y * tilesX_ + x));
  };
  begin_.assign(tileCount() + 2, 0);
  for (const Index face : order) forEachTile(face, [&](std::size_t tile) { ++begin_[tile + 2]; });
  for (std::size_t tile = 2; tile < begin_.size(); ++tile) begin_[tile] += begin_[tile - 1];
  binned_.resize(begin_.back());
  for (const Index face : order) forEachTile(face, [&](std::size_t tile) { binned_[begin_[tile + 1]++] = face; });
}

void FragmentSource::collect(std::size_t tile, std::vector<std::vector<ExactFragment>>& pixels) const {
  pixels.resize(kTileSize * kTileSize);
  for (auto& fragments : pixels) fragments.clear();
  for (std::size_t i = begin_[tile]; i < begin_[tile + 1]; ++i) collectFace(binned_[i], tile, pixels);
}

void FragmentSource::collectFace(Index face, std::size_t tile, std::vector<std::vector<ExactFragment>>& pixels) const {
  const auto& [i, j, k] = faces_.vertices[face];
  const Vec3 &a = projected_[i], &b = projected_[j], &c = projected_[k];
  const PixelBox whole = boxOf(face);
  const int column = firstColumn(tile), row = firstRow(tile);
  for (int y = std::max(whole.top, row); y <= std::min(whole.bottom, row + kTileSize - 1); ++y)
    for (int x = std::max(whole.left, column); x <= std::min(whole.right, column + kTileSize - 1); ++x) {
      const double px = x + 0.5, py = y + 0.5;
      const Edge ab = edge(a, b, px, py), bc = edge(b, c, px, py), ca = edge(c, a, px, py);
      if (ab.left != bc.left || bc.left != ca.left) continue;
      // Weights of the vertices on the screen, then (perspective) in space; all of one sign, so the mean stays between the vertices.
      double wa = bc.value, wb = ca.value, wc = ab.value;
      if (wa + wb + wc == 0) wa = wb = wc = 1;
      if (!view_.orthographic) wa /= a.z, wb /= b.z, wc /= c.z;
      const double sum = wa + wb + wc;
      auto mean = [&](std::span<const double> values) {
        return (wa * values[i] + wb * values[j] + wc * values[k]) / sum;
      };
      // Rows count downwards, so a face whose outside the eye sees turns to the right.
      const int kind = !faces_.isBoundary(face) ? 0 : ab.left ? -1 : 1;
      pixels[static_cast<std::size_t>((y - row) * kTileSize + x - column)].push_back(
          {scalars_.empty() ? 0.0 : mean(scalars_), mean(depths_) * view_.rayScale(px, py), kind});
    }
}

}  // namespace havs::test
