#include "support/pixel_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/image.h"

namespace havs::test {
namespace {

constexpr int kSteps = 256;  // of the rasteriser's grid a pixel

double difference(const RayColor& a, const RayColor& b) {
  double worst = 0;
  for (std::size_t c = 0; c < 4; ++c) worst = std::max(worst, std::abs(a[c] - b[c]));
  return worst;
}

double distanceToSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double squared = dot(along, along);
  const double t = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
  return length(p - (a + t * along));
}

/// Twice the signed area of a, b and (x, y).
template <class Corner>
double side(const Corner& a, const Corner& b, double x, double y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

/// The side of the edge from a to b that the pixel's centre lies on, in exact arithmetic.
template <class Point, class Tie>
int snappedSide(const Point& a, const Point& b, std::int64_t x, std::int64_t y, const Tie& tie) {
  const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
  std::int64_t value = dx * (y - a.y) - dy * (x - a.x);
  if (value == 0) value = -dy * tie.x;
  if (value == 0) value = dx * tie.y;
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// Pixels to the grid's steps, before they are rounded.
double gridPlace(double pixels) { return kSteps * (pixels - 0.5); }

/// The other step that a place this near to halfway may be rounded to; the same one where there is no doubt.
std::int64_t otherStep(double place, double doubt) {
  const auto nearest = std::llround(place);
  const auto other = nearest + (place > static_cast<double>(nearest) ? 1 : -1);
  return std::abs(place - static_cast<double>(nearest)) > 0.5 - doubt ? other : nearest;
}

RayColor pixelOf(const Image& image, int x, int y) {
  const float* p = image.pixel(x, y);
  return {p[0], p[1], p[2], p[3]};
}

}  // namespace

PixelTracer::PixelTracer(const PreparedScene& prepared, const View& view) : prepared_(prepared), view_(view) {
  for (const Vec3& p : prepared.points) {
    const Vec3 q = view.project(p);
    corners_.push_back({q.x, q.y, view.orthographic ? 1.0 : 1.0 / q.z, view.depth(p)});
    snapped_.push_back({std::llround(gridPlace(q.x)), std::llround(gridPlace(q.y))});
  }
  // Clip coordinates are sums of four float products, and the planes of interpolation are solved for in float over
  // coordinates as large as the picture: a few units in the last place of its size.
  constexpr double kRoundings = 4;
  floatPixels_ = kRoundings * std::max(view.width, view.height) * std::exp2(-24);
}

std::array<PixelTracer::Corner, 3> PixelTracer::cornersOf(Index face) const {
  const auto& v = prepared_.faces.vertices[face];
  return {corners_[v[0]], corners_[v[1]], corners_[v[2]]};
}

/// Whose projection may cover the pixel once the grid has moved it.
std::vector<Index> PixelTracer::facesNear(double x, double y) const {
  constexpr double kReach = 2.0 / kSteps;
  std::vector<Index> near;
  for (std::size_t f = 0; f < prepared_.faces.size(); ++f) {
    const auto [a, b, c] = cornersOf(static_cast<Index>(f));
    if (std::min({a.x, b.x, c.x}) - kReach <= x && x <= std::max({a.x, b.x, c.x}) + kReach &&
        std::min({a.y, b.y, c.y}) - kReach <= y && y <= std::max({a.y, b.y, c.y}) + kReach)
      near.push_back(static_cast<Index>(f));
  }
  return near;
}

bool PixelTracer::covers(Index face, double x, double y) const {
  const auto [a, b, c] = cornersOf(face);
  const double ab = side(a, b, x, y), bc = side(b, c, x, y), ca = side(c, a, x, y);
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

bool PixelTracer::coversSnapped(Index face, int pixelX, int pixelY, const Tie& tie, const GridMoves& moves) const {
  std::array<GridPoint, 3> p;
  for (std::size_t i = 0; i < 3; ++i) {
    const Index corner = prepared_.faces.vertices[face][i];
    const auto moved = moves.find(corner);
    p[i] = moved == moves.end() ? snapped_[corner] : moved->second;
  }
  const std::int64_t x = kSteps * std::int64_t{pixelX}, y = kSteps * std::int64_t{pixelY};
  const int first = snappedSide(p[0], p[1], x, y, tie);
  return first != 0 && first == snappedSide(p[1], p[2], x, y, tie) && first == snappedSide(p[2], p[0], x, y, tie);
}

double PixelTracer::distanceToEdge(Index face, double x, double y) const {
  const auto [a, b, c] = cornersOf(face);
  const Vec2 centre{x, y}, pa{a.x, a.y}, pb{b.x, b.y}, pc{c.x, c.y};
  return std::min(
      {distanceToSegment(centre, pa, pb), distanceToSegment(centre, pb, pc), distanceToSegment(centre, pc, pa)});
}

/// The plane of the face at one place of the picture, taken for a fragment of the pixel at another.
PixelTracer::Fragment PixelTracer::fragmentAt(Index face, double planeX, double planeY, double pixelX,
                                              double pixelY) const {
  const auto corners = cornersOf(face);
  const auto& [a, b, c] = corners;
  std::array<double, 3> weight{side(b, c, planeX, planeY) * a.nearness, side(c, a, planeX, planeY) * b.nearness,
                               side(a, b, planeX, planeY) * c.nearness};
  const double sum = weight[0] + weight[1] + weight[2];
  const bool towardsEye = side(a, b, c.x, c.y) < 0;  // y goes down: clockwise in the picture's coordinates is front
  const bool cellData = prepared_.field.centering == Centering::cell;
  Fragment fragment{face, 0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    fragment.distance += weight[i] / sum * corners[i].depth * view_.rayScale(pixelX, pixelY);
    if (!cellData) fragment.scalar += weight[i] / sum * prepared_.scalars[prepared_.faces.vertices[face][i]];
  }
  if (prepared_.faces.isBoundary(face)) fragment.kind = towardsEye ? 1 : -1;
  const Index behind = prepared_.faces.cells[face][towardsEye ? 0 : 1];
  if (cellData && behind != kNoIndex) fragment.scalar = prepared_.scalars[behind];
  fragment.scalar = std::clamp(fragment.scalar, 0.0, 1.0);
  return fragment;
}

/// As the k-buffer would with room for all: sorted by distance, segments where the ray is inside the mesh.
RayColor PixelTracer::composite(std::vector<Fragment> fragments) const {
  std::sort(fragments.begin(), fragments.end(),
            [](const Fragment& a, const Fragment& b) { return a.distance < b.distance; });
  const bool cellData = prepared_.field.centering == Centering::cell;
  std::vector<CellSegment> segments;
  int inside = 0;
  for (std::size_t i = 0; i + 1 < fragments.size(); ++i) {
    const Fragment &front = fragments[i], &back = fragments[i + 1];
    inside += front.kind;
    if (inside > 0)
      segments.push_back(
          {front.distance, back.distance, front.scalar, cellData ? front.scalar : back.scalar, kNoIndex});
  }
  return rayColor({prepared_.curve, prepared_.isosurfaces}, segments);
}

TracedFragment PixelTracer::describe(const Fragment& fragment, double x, double y) const {
  const auto& v = prepared_.faces.vertices[fragment.face];
  const Vec3 p = prepared_.points[v[0]], q = prepared_.points[v[1]], r = prepared_.points[v[2]];
  const double across = (2 * x / view_.width - 1) * view_.halfWidth, up = (1 - 2 * y / view_.height) * view_.halfHeight;
  const Vec3 ray = view_.orthographic ? view_.forward : normalize(view_.forward + across * view_.right + up * view_.up);
  const double sine = std::abs(dot(normalize(cross(q - p, r - p)), ray));

  constexpr double kStep = 1e-3;
  const auto distanceAt = [&](double dx, double dy) {
    return fragmentAt(fragment.face, x + dx, y + dy, x, y).distance;
  };
  const double slope = (std::abs(distanceAt(kStep, 0) - distanceAt(-kStep, 0)) +
                        std::abs(distanceAt(0, kStep) - distanceAt(0, -kStep))) /
                       (2 * kStep);
  const double edge = distanceToEdge(fragment.face, x, y);
  constexpr double kDegrees = 57.29577951308232;
  return {fragment.face,
          fragment.kind,
          fragment.distance,
          fragment.scalar,
          kDegrees * std::asin(std::min(1.0, sine)),
          edge,
          slope,
          slope * floatPixels_,
          0};
}

double PixelTracer::effectOf(const std::vector<Fragment>& fragments, std::size_t moved, double x, double y,
                             const RayColor& unmoved) const {
  double effect = 0;
  for (const Vec2& move : {Vec2{floatPixels_, 0}, {-floatPixels_, 0}, {0, floatPixels_}, {0, -floatPixels_}}) {
    std::vector<Fragment> others = fragments;
    others[moved] = fragmentAt(fragments[moved].face, x + move.x, y + move.y, x, y);
    effect = std::max(effect, difference(composite(std::move(others)), unmoved));
  }
  return effect;
}

TracedRay PixelTracer::traceRay(const std::vector<Index>& faces, double x, double y) const {
  std::vector<Fragment> fragments;
  for (const Index face : faces) fragments.push_back(fragmentAt(face, x, y, x, y));
  std::sort(fragments.begin(), fragments.end(),
            [](const Fragment& a, const Fragment& b) { return a.distance < b.distance; });
  TracedRay ray{.color = composite(fragments)};
  constexpr double kSegmentRounding = 2.4e-7;  // 2^-22: a colour of at most 1, some operations in float
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    ray.fragments.push_back(describe(fragments[i], x, y));
    ray.fragments.back().effect = effectOf(fragments, i, x, y, ray.color);
    ray.floatEffect += ray.fragments.back().effect + kSegmentRounding;
  }
  return ray;
}

TracedRay PixelTracer::snappedRay(const std::vector<Index>& near, int x, int y, const Tie& tie,
                                  const GridMoves& moves) const {
  std::vector<Index> faces;
  for (const Index face : near)
    if (coversSnapped(face, x, y, tie, moves)) faces.push_back(face);
  return traceRay(faces, x + 0.5, y + 0.5);
}

/// Corners of faces that have an edge beside the pixel's centre, halfway between two steps as far as float can tell,
/// with the step that the nearest one is not.
std::vector<std::pair<Index, PixelTracer::GridPoint>> PixelTracer::doubtfulCorners(const std::vector<Index>& near,
                                                                                   double x, double y) const {
  std::map<Index, GridPoint> doubtful;
  for (const Index face : near) {
    if (distanceToEdge(face, x, y) > 2.0 / kSteps) continue;
    for (const Index corner : prepared_.faces.vertices[face]) {
      const double doubt = kSteps * floatPixels_;
      const GridPoint other{otherStep(gridPlace(corners_[corner].x), doubt),
                            otherStep(gridPlace(corners_[corner].y), doubt)};
      if (other.x != snapped_[corner].x || other.y != snapped_[corner].y) doubtful[corner] = other;
    }
  }
  return {doubtful.begin(), doubtful.end()};
}

/// The colour nearest to what was seen, over what cannot be known of the rasteriser: its rule for a centre on an edge,
/// and the step that float coordinates halfway between two were rounded to (these are tried one by one).
TracedRay PixelTracer::nearestSnapped(const std::vector<Index>& near, int x, int y, const RayColor& seen) const {
  TracedRay nearest;
  double least = 1e300;
  const auto consider = [&](const Tie& tie, const GridMoves& moves) {
    TracedRay ray = snappedRay(near, x, y, tie, moves);
    if (difference(ray.color, seen) >= least) return;
    least = difference(ray.color, seen);
    nearest = std::move(ray);
  };
  const std::array<Tie, 4> ties{{{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};
  for (const Tie& tie : ties) consider(tie, {});
  if (least <= nearest.floatEffect) return nearest;
  for (const auto& [corner, other] : doubtfulCorners(near, x + 0.5, y + 0.5))
    for (const Tie& tie : ties) consider(tie, {{corner, other}});
  return nearest;
}

PixelTrace PixelTracer::trace(int x, int y, const Image& picture, const Image& reference, std::size_t late) const {
  const RayColor seen = pixelOf(picture, x, y);
  PixelTrace trace{.x = x, .y = y, .error = difference(seen, pixelOf(reference, x, y)), .late = late};
  const std::vector<Index> near = facesNear(x + 0.5, y + 0.5);
  std::vector<Index> faces;
  for (const Index face : near)
    if (covers(face, x + 0.5, y + 0.5)) faces.push_back(face);
  trace.exact = traceRay(faces, x + 0.5, y + 0.5);
  trace.snapped = nearestSnapped(near, x, y, seen);
  trace.gridEffect = difference(trace.exact.color, trace.snapped.color);
  trace.unexplained = difference(trace.snapped.color, seen);
  trace.cause = late > 0                                         ? Cause::order
                : trace.error <= trace.exact.floatEffect         ? Cause::rounding
                : trace.unexplained <= trace.snapped.floatEffect ? Cause::grid
                                                                 : Cause::none;
  return trace;
}

double PixelTrace::smallestAngle() const {
  double least = 90;
  for (const TracedFragment& f : exact.fragments) least = std::min(least, f.angle);
  return least;
}

double PixelTrace::nearestEdge() const {
  double least = 1e300;
  for (const TracedFragment& f : exact.fragments) least = std::min(least, f.edge);
  return least;
}

std::string nameOf(Cause cause) {
  switch (cause) {
    case Cause::order:
      return "late fragments";
    case Cause::rounding:
      return "float coordinates";
    case Cause::grid:
      return "sub-pixel grid";
    case Cause::none:
      break;
  }
  return "not explained";
}

std::string summary(const PixelTrace& trace) {
  return fmt::format(
      "pixel {},{}: error {:.3g}: {}; {} fragments, {} late; float may move it by {:.2g}, the grid moves it by {:.3g}, "
      "which leaves {:.2g}; smallest angle {:.2g} degrees, nearest edge {:.2g}/256 pixel\n",
      trace.x, trace.y, trace.error, nameOf(trace.cause), trace.exact.fragments.size(), trace.late,
      trace.exact.floatEffect, trace.gridEffect, trace.unexplained, trace.smallestAngle(), 256 * trace.nearestEdge());
}

std::string listOf(const TracedRay& ray) {
  std::string text;
  for (const TracedFragment& f : ray.fragments)
    text += fmt::format(
        "  face {:8} {:>5} distance {:+.7f} scalar {:.6f} angle {:8.4f} edge {:9.3f}/256 slope {:9.3g} "
        "float error {:9.2e} effect {:9.2e}\n",
        f.face,
        f.kind > 0   ? "entry"
        : f.kind < 0 ? "exit"
                     : "",
        f.distance, f.scalar, f.angle, 256 * f.edge, f.slope, f.floatError, f.effect);
  return text;
}

}  // namespace havs::test
