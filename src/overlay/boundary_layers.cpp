#include "overlay/boundary_layers.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "overlay/line_coverage.h"
#include "raster/edge_function.h"
#include "raster/face_hit.h"

namespace havs {
namespace {

constexpr int kBandRows = 8;  // drawn by one thread at a time

/// A layer, and the pixel of its band that it belongs to.
struct Found {
  std::uint32_t pixel;
  RayLayer layer;
};
using FaceList = std::vector<std::uint32_t>;

/// A face as the picture has it.
class FaceInPicture {
 public:
  /// `lines`: of its wire frame.
  FaceInPicture(const BoundaryFace& face, const std::vector<ScreenPoint>& points, const View& view,
                std::vector<PictureLine> lines = {})
      : face_(face), view_(view), lines_(std::move(lines)) {
    for (std::size_t i = 0; i < 3; ++i) corner_[i] = points[face.corners[i]];
    for (std::size_t i = 0; i < 3; ++i)
      limit_[i] = edgeLimit(corner_[i], corner_[(i + 1) % 3], view.width, view.height);
  }

  PixelBox box() const { return boxOf({corner_[0], corner_[1], corner_[2], corner_[2]}, view_.width, view_.height); }

  /// hitFace, which is left to decide where doubles do not.
  FaceHit hit(double x, double y) const {
    std::array<double, 3> product;  // of the edges from corner i to the next
    for (std::size_t i = 0; i < 3; ++i) {
      const ScreenPoint &a = corner_[i], &b = corner_[(i + 1) % 3];
      product[i] = (a.x - x * a.w) * (b.y - y * b.w) - (a.y - y * a.w) * (b.x - x * b.w);
      if (!(std::abs(product[i]) > limit_[i]))
        return hitFace(corner_[0], corner_[1], corner_[2], x, y, view_.width, view_.height);
    }
    const bool positive = product[0] > 0;
    if (positive != (product[1] > 0) || positive != (product[2] > 0)) return {};
    return {positive ? 1 : -1, product[1], product[2], product[0]};
  }

  /// Whether it is met before the eye, and how deep.
  bool depthAt(const FaceHit& hit, double& depth) const {
    const double scale = 1 / (hit.a + hit.b + hit.c);
    const auto mean = [&](double a, double b, double c) { return (hit.a * a + hit.b * b + hit.c * c) * scale; };
    depth = mean(corner_[0].depth, corner_[1].depth, corner_[2].depth);
    return mean(corner_[0].w, corner_[1].w, corner_[2].w) > 0 && std::isfinite(depth);
  }

  double wireCoverage(double x, double y, double width) const {
    double covered = 0;
    for (const PictureLine& line : lines_) covered = std::max(covered, lineCoverage(line.distance(x, y), width));
    return covered;
  }

  /// What the head light gives: |n.r|.
  double towardsEye(double x, double y, double rayScale) const {
    if (view_.orthographic) return std::abs(dot(face_.normal, view_.forward));
    const Vec3 along = view_.forward + (2 * x / view_.width - 1) * view_.halfWidth * view_.right +
                       (1 - 2 * y / view_.height) * view_.halfHeight * view_.up;
    return std::abs(dot(face_.normal, along)) / rayScale;
  }

 private:
  const BoundaryFace& face_;
  const View& view_;
  std::array<ScreenPoint, 3> corner_;
  std::array<double, 3> limit_{};
  std::vector<PictureLine> lines_;
};

std::array<float, 4> colorOf(const Overlays& overlays, const FaceInPicture& face, double x, double y, double rayScale) {
  std::array<double, 4> rgba{};
  if (const auto& surface = overlays.surface) {
    constexpr double kAmbient = BoundarySurface::kAmbient;
    const double light = surface->shaded ? kAmbient + (1 - kAmbient) * face.towardsEye(x, y, rayScale) : 1;
    for (std::size_t c = 0; c < 3; ++c) rgba[c] = surface->opacity * light * surface->color[c];
    rgba[3] = surface->opacity;
  }
  if (const auto& wire = overlays.wireFrame) {
    const double alpha = wire->opacity * face.wireCoverage(x, y, wire->width);
    for (std::size_t c = 0; c < 3; ++c) rgba[c] = alpha * wire->color[c] + (1 - alpha) * rgba[c];
    rgba[3] = alpha + (1 - alpha) * rgba[3];
  }
  std::array<float, 4> color;
  std::transform(rgba.begin(), rgba.end(), color.begin(), [](double c) { return static_cast<float>(c); });
  return color;
}

void addFace(const Overlays& overlays, const FaceInPicture& face, const PixelBox& box, int top, const View& view,
             std::vector<Found>& found) {
  for (int row = box.top; row <= box.bottom; ++row)
    for (int column = box.left; column <= box.right; ++column) {
      const double x = column + 0.5, y = row + 0.5;
      const FaceHit hit = face.hit(x, y);
      double depth = 0;
      if (hit.sign == 0 || !face.depthAt(hit, depth)) continue;
      const double rayScale = view.rayScale(x, y);
      const RayLayer layer{depth * rayScale, colorOf(overlays, face, x, y, rayScale)};
      if (layer.rgba[3] > 0) found.push_back({static_cast<std::uint32_t>((row - top) * view.width + column), layer});
    }
}

}  // namespace

/// What a view's pixels are drawn from.
struct BoundaryLayers::InView {
  const BoundaryLayers& boundary;
  const View& view;
  std::vector<ScreenPoint> points;
  std::vector<char> turned;  ///< of each face: whether its outside is turned to the eye; with feature edges

  InView(const BoundaryLayers& of, const View& seen)
      : boundary(of), view(seen), points(screenPoints(of.prepared_.points, seen)) {
    if (!of.features_) return;
    for (const BoundaryFace& face : of.faces_) {
      const Vec3 toEye = view.orthographic ? -view.forward : view.eye - of.prepared_.points[face.corners[0]];
      turned.push_back(dot(face.normal, toEye) > 0 ? 1 : 0);
    }
  }

  FaceInPicture face(std::size_t f) const {
    return FaceInPicture(boundary.faces_[f], points, view,
                         boundary.overlays_.wireFrame ? lines(f) : std::vector<PictureLine>());
  }

  std::vector<PictureLine> lines(std::size_t f) const {
    const auto& corners = boundary.faces_[f].corners;
    std::vector<PictureLine> lines;
    const auto add = [&](Index from, Index to) {
      if (const auto line = lineBetween(points[from], points[to])) lines.push_back(*line);
    };
    if (!boundary.features_) {
      for (std::size_t i = 0; i < 3; ++i) add(corners[i], corners[(i + 1) % 3]);
      return lines;
    }
    for (const Index corner : corners)
      for (const std::uint32_t e : boundary.features_->at(corner))
        if (const EdgeOfFace& edge = boundary.features_->all()[e]; turned[edge.face] == turned[f])
          add(edge.from, edge.to);
    return lines;
  }
};

BoundaryLayers::BoundaryLayers(const PreparedScene& prepared, const Overlays& overlays)
    : prepared_(prepared), overlays_(overlays), faces_(boundaryFaces(prepared)) {
  if (const auto& wire = overlays.wireFrame; wire && wire->featureAngle)
    features_.emplace(faces_, prepared.points.size(), *wire->featureAngle);
}

RayLayers BoundaryLayers::of(const View& view) const {
  const InView inView(*this, view);
  std::vector<PixelBox> boxes(faces_.size());
  parallelFor(0, faces_.size(), 4096,
              [&](std::size_t f) { boxes[f] = FaceInPicture(faces_[f], inView.points, view).box(); });
  const auto bands = static_cast<std::size_t>((view.height + kBandRows - 1) / kBandRows);
  std::vector<FaceList> facesOf(bands);
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (boxes[f].empty()) continue;
    for (int band = boxes[f].top / kBandRows; band <= boxes[f].bottom / kBandRows; ++band)
      facesOf[static_cast<std::size_t>(band)].push_back(static_cast<std::uint32_t>(f));
  }

  std::vector<std::vector<Found>> foundIn(bands);
  parallelFor(0, bands, 1, [&](std::size_t band) {
    const int top = static_cast<int>(band) * kBandRows;
    const PixelBox rows{0, top, view.width - 1, std::min(top + kBandRows, view.height) - 1};
    std::vector<Found>& found = foundIn[band];
    for (const std::uint32_t f : facesOf[band])
      addFace(overlays_, inView.face(f), intersection(boxes[f], rows), top, view, found);
    std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
      return a.pixel != b.pixel ? a.pixel < b.pixel : a.layer.distance < b.layer.distance;
    });
  });

  RayLayers layers{view.width, view.height, {}, {}};
  layers.begin.assign(layers.pixel(0, view.height) + 1, 0);
  for (std::size_t band = 0; band < bands; ++band)
    for (const Found& found : foundIn[band]) {
      ++layers.begin[layers.pixel(0, static_cast<int>(band) * kBandRows) + found.pixel + 1];
      layers.layers.push_back(found.layer);
    }
  for (std::size_t i = 1; i < layers.begin.size(); ++i) layers.begin[i] += layers.begin[i - 1];
  return layers;
}

}  // namespace havs
