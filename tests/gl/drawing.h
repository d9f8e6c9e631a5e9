#pragma once
// What the tests of pictures share: a scene in memory drawn on a device, and how far a picture is from what it should
// be.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "image/image.h"
#include "reference/edge_mask.h"
#include "render/make_renderer.h"
#include "scene/prepared_scene.h"
#include "sort/face_order.h"
#include "support/meshes.h"

namespace havs::test {

/// A transfer function in a file of its own, gone with the object.
class TransferFile {
 public:
  explicit TransferFile(const std::string& json) {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("havs_tf_" + std::to_string(getpid()) + "_" + std::to_string(count++) + ".json");
    std::ofstream(path_) << json;
  }
  ~TransferFile() { std::filesystem::remove(path_); }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// One colour and one extinction (per mesh unit) at every scalar of [0, 1].
inline std::string constantTransfer(double kappa, const std::string& color = "[0.8, 0.4, 0.2]") {
  const std::string point = R"(, "color": )" + color + R"(, "opacity": )" + std::to_string(kappa) + "}";
  return R"({"version": 1, "opacity": "extinction", "unit_length": 1, "domain": [0, 1], "points": [{"scalar": 0)" +
         point + R"(, {"scalar": 1)" + point + "]}";
}

inline TetMesh withPointField(TetMesh mesh, std::vector<double> values) {
  mesh.pointFields = {Field{"s", 1, std::move(values)}};
  return mesh;
}

struct Drawing {
  PreparedScene prepared;
  View view;
  Image image;
  std::optional<Certificate> certificate;
};

/// Draws on `device`, which must be current.
inline Drawing draw(const Device& device, const Scene& scene, TetMesh mesh) {
  StageTimes stages;
  Drawing drawing{prepareScene(scene, std::move(mesh), stages), {}, {}, {}};
  drawing.view = makeView(scene.camera, drawing.prepared.frame, scene.width, scene.height);
  const RenderPlan chosen = plan(scene, drawing.prepared.facts(), capabilitiesOf(device));
  havs::Drawing drawn = makeRenderer(drawing.prepared, chosen, stages)->draw(drawing.view, stages);
  drawing.image = std::move(drawn.image);
  drawing.certificate = std::move(drawn.certificate);
  return drawing;
}

inline std::vector<unsigned char> maskOf(const Drawing& drawing) {
  return boundaryEdgeMask(drawing.prepared.points, drawing.prepared.faces, drawing.view);
}

/// The ray of a pixel's centre in mesh units: origin + t * direction, direction of length 1.
struct Ray {
  Vec3 origin, direction;
};
inline Ray rayOf(const Drawing& drawing, int x, int y) {
  const View& view = drawing.view;
  const double u = (2.0 * (x + 0.5) / view.width - 1.0) * view.halfWidth;
  const double v = (1.0 - 2.0 * (y + 0.5) / view.height) * view.halfHeight;
  const Vec3 across = u * view.right + v * view.up;
  const LocalFrame& frame = drawing.prepared.frame;
  if (view.orthographic) return {frame.center + frame.radius * (view.center + across), view.forward};
  return {frame.center + frame.radius * view.eye, normalize(view.forward + across)};
}

/// Where a ray goes through the box low..high: parameters of entry and exit, exit <= entry where it misses.
inline std::pair<double, double> throughBox(const Ray& ray, const Vec3& low, const Vec3& high) {
  double first = -1e300, last = 1e300;
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0) {
      if (ray.origin[axis] < low[axis] || ray.origin[axis] > high[axis]) return {0, 0};
      continue;
    }
    double a = (low[axis] - ray.origin[axis]) / ray.direction[axis];
    double b = (high[axis] - ray.origin[axis]) / ray.direction[axis];
    if (a > b) std::swap(a, b);
    first = std::max(first, a);
    last = std::min(last, b);
  }
  return {first, last};
}
inline double lengthInBox(const Ray& ray, const Vec3& low, const Vec3& high) {
  const auto [first, last] = throughBox(ray, low, high);
  return std::max(0.0, last - first);
}

struct Difference {
  double maximum = 0;
  int x = -1, y = -1;
  std::size_t beyond = 0;  ///< pixels further off than the limit given
  std::size_t compared = 0;
};
inline std::ostream& operator<<(std::ostream& out, const Difference& d) {
  return out << "maximum " << d.maximum << " at " << d.x << "," << d.y << "; " << d.beyond << " of " << d.compared
             << " beyond";
}

/// Against expected opacity at every pixel that the mask leaves.
inline Difference againstOpacity(const Drawing& drawing, const std::function<double(int x, int y)>& expected,
                                 double limit = 1e-5) {
  const auto mask = maskOf(drawing);
  Difference difference;
  for (int y = 0; y < drawing.image.height; ++y)
    for (int x = 0; x < drawing.image.width; ++x) {
      if (mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(drawing.image.width) +
               static_cast<std::size_t>(x)])
        continue;
      ++difference.compared;
      const double error = std::abs(drawing.image.pixel(x, y)[3] - expected(x, y));
      if (!(error <= limit)) ++difference.beyond;
      if (!(error <= difference.maximum)) {
        difference.maximum = error;
        difference.x = x;
        difference.y = y;
      }
    }
  return difference;
}

/// Largest difference of any channel of two pictures.
inline Difference between(const Image& a, const Image& b, double limit = 1e-5,
                          const std::vector<unsigned char>& mask = {}) {
  Difference difference;
  for (std::size_t i = 0; i < a.rgba.size() / 4; ++i) {
    if (!mask.empty() && mask[i]) continue;
    ++difference.compared;
    double error = 0;
    for (std::size_t c = 0; c < 4; ++c)
      error = std::max<double>(error, std::abs(a.rgba[4 * i + c] - b.rgba[4 * i + c]));
    if (!(error <= limit)) ++difference.beyond;
    if (!(error <= difference.maximum)) {
      difference.maximum = error;
      difference.x = static_cast<int>(i) % a.width;
      difference.y = static_cast<int>(i) / a.width;
    }
  }
  return difference;
}

}  // namespace havs::test
