#pragma once
// A smooth field under a smooth transfer function, and what rays see of it, by quadrature along them: no mesh is
// involved. All in mesh units.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "hard/hard_case.h"
#include "reference/ray_color.h"
#include "support/meshes.h"
#include "unit/gauss_kronrod.h"
#include "unit/reference/rays.h"

namespace havs::test {

/// Between 0.1 and 0.9 in the unit box; all second derivatives are of order 1.
inline double smoothScalar(const Vec3& p) {
  return 0.5 + 0.25 * std::sin(1.3 * p.x + 0.4) * std::cos(1.1 * p.y - 0.2) + 0.15 * std::sin(1.7 * p.z + 0.3 * p.x);
}

/// (r, g, b, extinction a mesh unit) over scalars of [0, 1].
inline std::array<double, 4> smoothTransfer(double s) {
  return {0.5 + 0.4 * std::sin(3 * s), 0.5 + 0.4 * std::cos(2.5 * s), 0.6 + 0.3 * std::sin(2 * s + 1),
          0.8 + 0.6 * std::sin(4 * s + 0.5)};
}

/// The transfer function as a file of so many linear pieces that they are off by 2e-6 at most: (1/1024)^2 / 8 times
/// second derivatives of up to 10.
inline std::string smoothTransferFile() {
  constexpr int kPieces = 1024;
  std::vector<std::array<double, 5>> points;
  for (int i = 0; i <= kPieces; ++i) {
    const double s = static_cast<double>(i) / kPieces;
    const auto [r, g, b, kappa] = smoothTransfer(s);
    points.push_back({s, r, g, b, kappa});
  }
  return transferFile(transferOf(points));
}

using Along = std::function<std::array<double, 4>(double t)>;  ///< colour and extinction at a place of a ray

/// Emission and absorption along [first, last]: Gauss-Kronrod in Gauss-Kronrod, in equal panels.
inline RayColor quadrature(const Along& along, double first, double last, int panels = 4) {
  RayColor sum{0, 0, 0, 0};
  if (!(first < last)) return sum;
  long double depth = 0;  // up to the panel
  const auto kappa = [&](long double t) -> long double { return along(static_cast<double>(t))[3]; };
  for (int p = 0; p < panels; ++p) {
    const long double a = first + (last - first) * static_cast<long double>(p) / panels;
    const long double b = first + (last - first) * static_cast<long double>(p + 1) / panels;
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += static_cast<double>(kronrod15(
          [&](long double t) -> long double {
            const auto at = along(static_cast<double>(t));
            return at[c] * at[3] * std::exp(-depth - kronrod15(kappa, a, t));
          },
          a, b));
    depth += kronrod15(kappa, a, b);
  }
  sum[3] = static_cast<double>(-std::expm1(-depth));
  return sum;
}

/// The ray of a pixel in mesh units, and its part within a body.
struct BodyRay {
  Vec3 origin, direction;
  double first = 0, last = 0;
  Vec3 at(double t) const { return origin + t * direction; }
};

/// Through [-1, 1]^3.
inline BodyRay boxRay(const HardPicture& picture, int x, int y) {
  const LocalFrame& frame = picture.prepared.frame;
  const Ray local = rayOf(picture.view, x, y);
  const Ray ray{frame.center + frame.radius * local.origin, local.direction, frame.radius * local.start};
  const Stretch inside = throughBox(ray, Vec3(-1), Vec3(1));
  return {ray.origin, ray.direction, inside.first, inside.last};
}

/// Through the unit ball.
inline BodyRay ballRay(const HardPicture& picture, int x, int y) {
  BodyRay ray = boxRay(picture, x, y);
  const double middle = -dot(ray.origin, ray.direction);
  const Vec3 nearest = ray.at(middle);
  const double half = std::sqrt(std::max(0.0, 1 - dot(nearest, nearest)));
  ray.first = middle - half;
  ray.last = middle + half;
  return ray;
}

/// What each pixel's ray sees, row by row.
using BodyRays = std::function<BodyRay(const HardPicture&, int x, int y)>;
using SeenBy = std::function<RayColor(const BodyRay& ray)>;
inline std::vector<RayColor> seen(const HardPicture& picture, const BodyRays& rays, const SeenBy& by) {
  std::vector<RayColor> colors;
  for (int y = 0; y < picture.view.height; ++y)
    for (int x = 0; x < picture.view.width; ++x) colors.push_back(by(rays(picture, x, y)));
  return colors;
}

/// The volume of the smooth field under the smooth transfer function.
inline RayColor smoothVolume(const BodyRay& ray) {
  return quadrature([&](double t) { return smoothTransfer(smoothScalar(ray.at(t))); }, ray.first, ray.last);
}

struct Norms {
  double mean = 0, rms = 0, most = 0;
};
inline std::vector<RayColor> pixelsOf(const Image& image) {
  std::vector<RayColor> pixels(image.rgba.size() / 4);
  for (std::size_t c = 0; c < image.rgba.size(); ++c) pixels[c / 4][c % 4] = double{image.rgba[c]};
  return pixels;
}

/// Of the errors of all channels of the pixels that `mask` leaves.
inline Norms normsOf(const std::vector<RayColor>& picture, const std::vector<RayColor>& truth,
                     const std::vector<unsigned char>& mask = {}) {
  Norms norms;
  double count = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    for (std::size_t c = 0; c < 4; ++c) {
      if (!mask.empty() && mask[i] != 0) continue;
      const double error = std::abs(picture[i][c] - truth[i][c]);
      norms.mean += error;
      norms.rms += error * error;
      norms.most = std::max(norms.most, error);
      ++count;
    }
  norms.mean /= count;
  norms.rms = std::sqrt(norms.rms / count);
  return norms;
}
inline Norms normsOf(const Image& picture, const std::vector<RayColor>& truth,
                     const std::vector<unsigned char>& mask = {}) {
  return normsOf(pixelsOf(picture), truth, mask);
}

}  // namespace havs::test
