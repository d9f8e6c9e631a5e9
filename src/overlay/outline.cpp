#include "overlay/outline.h"

#include <algorithm>

#include "core/parallel.h"

namespace havs {
namespace {

constexpr double kSides[2] = {-1, 1};

/// Whether the eye sees the outside of the box's side at `sign` along an axis.
bool facesEye(const Vec3& halfSize, const View& view, int axis, double sign) {
  if (view.orthographic) return sign * view.forward[axis] < 0;
  return sign * view.eye[axis] > halfSize[axis];
}

using Coverage = std::vector<double>;

void cover(Coverage& row, const std::vector<PictureLine>& lines, int y, double width) {
  std::fill(row.begin(), row.end(), 0.0);
  for (const PictureLine& line : lines) {
    const auto [first, last] = pixelsNear(line, y, (width + 1) / 2, static_cast<int>(row.size()));
    for (int x = first; x <= last; ++x) {
      double& covered = row[static_cast<std::size_t>(x)];
      covered = std::max(covered, lineCoverage(line.distance(x + 0.5, y + 0.5), width));
    }
  }
}

/// The color, so much of it, over the pixel and under it.
void composite(float* pixel, const Color& color, double over, double under) {
  const double through = (1 - over) * (1 - static_cast<double>(pixel[3])) * under;
  const auto channel = [&](float value, double own) {
    return static_cast<float>(std::min(1.0, over * own + (1 - over) * static_cast<double>(value) + through * own));
  };
  for (std::size_t c = 0; c < 3; ++c) pixel[c] = channel(pixel[c], color[c]);
  pixel[3] = channel(pixel[3], 1);
}

}  // namespace

OutlineLines outlineLines(const Vec3& halfSize, const View& view) {
  OutlineLines lines;
  for (int axis = 0; axis < 3; ++axis) {
    const int second = (axis + 1) % 3, third = (axis + 2) % 3;
    for (const double bySecond : kSides)
      for (const double byThird : kSides) {
        Vec3 from, to;
        from[axis] = -halfSize[axis];
        to[axis] = halfSize[axis];
        from[second] = to[second] = bySecond * halfSize[second];
        from[third] = to[third] = byThird * halfSize[third];
        const auto line = lineBetween(screenPoint(from, view), screenPoint(to, view));
        if (!line) continue;
        const bool front = facesEye(halfSize, view, second, bySecond) || facesEye(halfSize, view, third, byThird);
        (front ? lines.front : lines.back).push_back(*line);
      }
  }
  return lines;
}

void addOutline(Image& image, const Outline& outline, const Vec3& halfSize, const View& view) {
  const OutlineLines lines = outlineLines(halfSize, view);
  constexpr std::size_t kRows = 16;
  parallelBlocks(0, static_cast<std::size_t>(image.height), kRows, [&](std::size_t first, std::size_t last) {
    Coverage over(static_cast<std::size_t>(image.width)), under(over.size());
    for (auto y = static_cast<int>(first); y < static_cast<int>(last); ++y) {
      cover(over, lines.front, y, outline.width);
      cover(under, lines.back, y, outline.width);
      for (int x = 0; x < image.width; ++x) {
        const auto at = static_cast<std::size_t>(x);
        if (over[at] > 0 || under[at] > 0) composite(image.pixel(x, y), outline.color, over[at], under[at]);
      }
    }
  });
}

}  // namespace havs
