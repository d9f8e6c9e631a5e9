#pragma once
// Scenes and fields of the tests of data.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "hard/every_mode.h"
#include "support/meshes.h"
#include "unit/reference/rays.h"

namespace havs::test {

inline constexpr double kLargest = std::numeric_limits<double>::max();
inline constexpr double kLeast = std::numeric_limits<double>::denorm_min();
inline constexpr int kCells = 4;  ///< of the box along each axis

/// Three extinctions, none 0: what the field is at the ends of its domain shows.
inline const std::vector<std::array<double, 5>>& points() {
  static const std::vector<std::array<double, 5>> rows{
      {0, 0.2, 0.4, 0.8, 0.5}, {0.5, 0.9, 0.8, 0.2, 1.5}, {1, 0.9, 0.5, 0.1, 1}};
  return rows;
}

inline Scene sceneOver(std::optional<std::array<double, 2>> domain) {
  Scene scene = hardScene();
  scene.transferFunction = transferFile(transferOf(points(), "extinction", 1, domain));
  return scene;
}

/// A function whose points are values in the data's unit.
inline Scene sceneInDataUnit(const std::vector<std::array<double, 5>>& rows) {
  Scene scene = hardScene();
  std::string json = transferOf(rows, "extinction", 1, {});
  json.insert(1, R"("scale": "data", )");
  scene.transferFunction = transferFile(json);
  return scene;
}

inline TetMesh withPoints(TetMesh mesh, std::vector<double> values) {
  mesh.pointFields = {Field{"s", 1, std::move(values)}};
  return mesh;
}

inline TetMesh constantBox(double value) {
  const TetMesh mesh = box(kCells);
  return withPoints(mesh, constantField(mesh.points, value));
}

/// The smooth field in whole steps, 0 to `most`: scaled by a power of two, or shifted, it keeps every digit.
inline TetMesh steppedBox(double most, const std::function<double(double)>& valueOf) {
  const TetMesh mesh = box(kCells, Cut::five, 0.2);
  auto values = smoothField(mesh.points);
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double from = *low, range = *high - *low;
  for (double& value : values) value = valueOf(std::round(most * (value - from) / range));
  return withPoints(mesh, values);
}

class DataTest : public EveryModeTest {
 protected:
  /// The picture is that of a body of one colour and extinction, in closed form, and every way and mode agrees.
  void expectConstant(const Scene& scene, const TetMesh& mesh, const std::array<double, 5>& point, double surface) {
    const HardPicture picture = expectEveryWay(scene, mesh);
    const double half = 1 / picture.prepared.frame.radius;
    double most = 0;
    for (int y = 0; y < picture.view.height; ++y)
      for (int x = 0; x < picture.view.width; ++x) {
        const double length = throughBox(rayOf(picture.view, x, y), Vec3(-half), Vec3(half)).length() / half;
        const double alpha = -std::expm1(-point[4] * length);
        for (std::size_t c = 0; c < 4; ++c) {
          const double expected = alpha * (c < 3 ? point[c + 1] : 1);
          const double got = double{picture.truth.pixel(x, y)[c]};
          most = std::max(most, std::abs(got - expected));
        }
      }
    expectAtMost("truth against closed form", most, 1e-7);  // it is rounded to float
    expectEveryMode(scene, mesh, surface);
  }

  /// The same picture to the last bit, by the reference and the native device.
  void expectSamePictures(const std::string& what, const HardPicture& a, const HardPicture& b) {
    expectSame(what + ", truth", a.truth, b.truth, 0);
    const HardWay native = hardWays().front();
    expectSame(what + ", native", drawIn(native, a.scene, a.prepared, a.view).image,
               drawIn(native, b.scene, b.prepared, b.view).image, 0);
  }
};

}  // namespace havs::test
