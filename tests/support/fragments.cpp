// Coverage in exact arithmetic: vertices are rounded to 2^-26 pixel, and a centre on an edge counts as moved by an
// infinitesimal (e, e^2). All faces then agree on which side of each edge a centre lies, also at faces seen edge-on,
// and every ray through a closed surface meets as many front as back faces.
#include "support/fragments.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/parallel.h"

namespace havs::test {
namespace {

constexpr double kSubPixels = 1 << 26;
constexpr double kFarthestPixel = 1 << 24;  // keeps the products below within 2^104

std::int64_t centre(int pixel) { return (2 * std::int64_t{pixel} + 1) * (std::int64_t{1} << 25); }

/// Twice the signed area of (a, b, p), and whether p, moved by (e, e^2), lies on the positive side of the line from a
/// to b. Degenerate edges (a == b) have none.
struct Edge {
  double value;
  bool positive;
};

Edge edge(const FragmentSource::SubPixel& a, const FragmentSource::SubPixel& b, const FragmentSource::SubPixel& p) {
  using Wide = __int128;
  const Wide dx = b.x - a.x, dy = b.y - a.y;
  const Wide value = dx * (p.y - a.y) - dy * (p.x - a.x);
  return {static_cast<double>(value), value != 0 ? value > 0 : dy != 0 ? dy < 0 : dx > 0};
}

}  // namespace

FragmentSource::FragmentSource(std::span<const Vec3> points, const Faces& faces, std::span<const Index> order,
                               std::span<const double> scalars, const View& view)
    : faces_(faces),
      scalars_(scalars),
      view_(view),
      pixels_(points.size()),
      nearness_(points.size()),
      depths_(points.size()),
      tilesX_((view.width + kTileSize - 1) / kTileSize),
      tilesY_((view.height + kTileSize - 1) / kTileSize) {
  parallelFor(0, points.size(), 4096, [&](std::size_t i) {
    const Vec3 projected = view.project(points[i]);
    if (!(std::abs(projected.x) < kFarthestPixel && std::abs(projected.y) < kFarthestPixel))
      throw std::invalid_argument("a point so far outside the picture cannot be replayed");
    if (!view.orthographic && !(projected.z > 0))
      throw std::invalid_argument("a point behind the eye cannot be replayed");
    pixels_[i] = {std::llround(projected.x * kSubPixels), std::llround(projected.y * kSubPixels)};
    nearness_[i] = view.orthographic ? 1.0 : 1.0 / projected.z;
    depths_[i] = view.depth(points[i]);
  });
  binFaces(order);
}

FragmentSource::PixelBox FragmentSource::boxOf(Index face) const {
  const auto& [i, j, k] = faces_.vertices[face];
  const SubPixel &a = pixels_[i], &b = pixels_[j], &c = pixels_[k];
  auto pixelOf = [](std::int64_t position) {
    return static_cast<int>(std::floor(static_cast<double>(position) / kSubPixels));
  };
  return {std::max(0, pixelOf(std::min({a.x, b.x, c.x}))), std::max(0, pixelOf(std::min({a.y, b.y, c.y}))),
          std::min(view_.width - 1, pixelOf(std::max({a.x, b.x, c.x}))),
          std::min(view_.height - 1, pixelOf(std::max({a.y, b.y, c.y})))};
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
  const SubPixel &a = pixels_[i], &b = pixels_[j], &c = pixels_[k];
  if (a == b || b == c || c == a) return;
  const PixelBox whole = boxOf(face);
  const int column = firstColumn(tile), row = firstRow(tile);
  for (int y = std::max(whole.top, row); y <= std::min(whole.bottom, row + kTileSize - 1); ++y)
    for (int x = std::max(whole.left, column); x <= std::min(whole.right, column + kTileSize - 1); ++x) {
      const SubPixel p{centre(x), centre(y)};
      const Edge ab = edge(a, b, p), bc = edge(b, c, p), ca = edge(c, a, p);
      if (ab.positive != bc.positive || bc.positive != ca.positive) continue;
      // Weights of the vertices: on the screen the opposite edge's area, in space divided by depth. All of one sign, so
      // that a mean stays between the values of the vertices.
      const double wa = bc.value * nearness_[i], wb = ca.value * nearness_[j], wc = ab.value * nearness_[k];
      const double sum = wa + wb + wc;
      auto mean = [&](std::span<const double> values) {
        return (wa * values[i] + wb * values[j] + wc * values[k]) / sum;
      };
      // Rows count downwards, so a face whose outside the eye sees turns to the right.
      const int kind = !faces_.isBoundary(face) ? 0 : ab.positive ? -1 : 1;
      pixels[static_cast<std::size_t>((y - row) * kTileSize + x - column)].push_back(
          {scalars_.empty() ? 0.0 : mean(scalars_), mean(depths_) * view_.rayScale(x + 0.5, y + 0.5), kind});
    }
}

std::uint32_t countLateByDefinition(std::span<const ExactFragment> fragments, int k) {
  constexpr double kTolerance = 1e-6;
  const auto nearer = [](const ExactFragment& a, const ExactFragment& b) { return a.distance < b.distance; };
  std::vector<ExactFragment> farthest;  // the k farthest so far, near first
  std::uint32_t late = 0;
  std::size_t left = 0;
  int inside = 0;
  for (const ExactFragment& f : fragments) {
    const bool full = farthest.size() == static_cast<std::size_t>(k);
    if (full && left > 0) {
      const bool ends = inside > 0 && f.kind < 0 && farthest.front().kind > 0;
      if (f.distance < farthest.front().distance + (ends ? kTolerance : -kTolerance)) {
        ++late;
        inside += f.kind;
        continue;
      }
    }
    farthest.insert(std::upper_bound(farthest.begin(), farthest.end(), f, nearer), f);
    if (!full) continue;
    inside += farthest.front().kind;
    farthest.erase(farthest.begin());
    ++left;
    if (k > 1 && inside > 0 && farthest[0].kind > 0 && farthest[1].kind < 0 &&
        farthest[1].distance - farthest[0].distance < kTolerance)
      std::swap(farthest[0].kind, farthest[1].kind);
  }
  return late;
}

}  // namespace havs::test
