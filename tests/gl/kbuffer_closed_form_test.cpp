// Pictures of every visibility method against closed forms: constant extinction kappa gives opacity 1 - exp(-kappa L),
// L the ray's length in the mesh.
#include <gtest/gtest.h>

#include "core/error.h"
#include "gl/drawing.h"
#include "support/gl_test.h"

namespace havs::test {
namespace {

constexpr double kKappa = 0.8;   // per mesh unit: times the diagonal of [-1, 1]^3, 2.8
constexpr double kFloat = 1e-5;  // float distances and 60 segments composited in float
constexpr int kBoxEdge = 4;

Scene smallScene(const std::string& transfer) {
  Scene scene;
  scene.transferFunction = transfer;
  scene.width = 120;
  scene.height = 90;
  scene.lookup = "post";
  scene.tableSize = 48;
  return scene;
}

/// A scene for each visibility method.
std::vector<Scene> byEveryMethod(const Scene& scene) {
  std::vector<Scene> scenes;
  for (const VisibilityMethod& method : visibilityMethods()) {
    scenes.push_back(scene);
    scenes.back().visibility = method.name;
  }
  return scenes;
}

TetMesh constantBox(double value = 0.5) {
  TetMesh mesh = box(kBoxEdge, Cut::six, 0.2);
  auto values = constantField(mesh.points, value);
  return withPointField(std::move(mesh), std::move(values));
}

double opacityOf(double length, double kappa = kKappa) { return -std::expm1(-kappa * length); }

double boxOpacity(const Drawing& drawing, int x, int y) {
  return opacityOf(lengthInBox(rayOf(drawing, x, y), Vec3(-1.0), Vec3(1.0)));
}

Difference againstBox(const Drawing& drawing, double limit = kFloat) {
  return againstOpacity(
      drawing, [&](int x, int y) { return boxOpacity(drawing, x, y); }, limit);
}

/// What linear interpolation of 1 - exp(-kappa D) between the table's lengths may be off by: a segment by (kappa h)^2 /
/// 8, a ray by that times the most segments it can have in the box: each of the planes of the grid and of the six cuts,
/// three families each way.
double tableBound(const Drawing& drawing, const Scene& scene) {
  const double kappa = kKappa * drawing.prepared.frame.radius;
  const double step = drawing.prepared.longestEdge / (tableSizeOf(scene) - 1);
  const double mostSegments = 3.0 * 6 * kBoxEdge;
  return kFloat + mostSegments * (kappa * step) * (kappa * step) / 8.0;
}

/// The opacity kappa h of a step is beyond 1 - exp(-kappa h) by at most (kappa h)^2 / 2; the steps of a ray add up.
double linearOpacityBound(const Drawing& drawing, int steps) {
  const double radius = drawing.prepared.frame.radius;
  const double longest = kKappa * radius * drawing.prepared.longestEdge / steps;
  return kFloat + 0.5 * longest * kKappa * 2 * std::sqrt(3.0);
}

/// How far the opacity of constant extinction may be off; all lookups that are not named here have it exactly.
double lookupBound(const Drawing& drawing, const Scene& scene) {
  const Lookup chosen = lookup(scene.lookup);
  if (chosen.name == "3d") return tableBound(drawing, scene);
  if (chosen.name.starts_with("riemann-linear")) return linearOpacityBound(drawing, chosen.number);
  return kFloat;
}

/// What an entry's rounding to a format may add: each of the ray's segments by half a step of the format, in half
/// floats by 2^-12 of its opacity, which add up to at most the optical depth, and half the smallest number.
double roundingOf(const std::string& format) {
  const double segments = 3.0 * 6 * kBoxEdge;
  if (format == "rgba8") return segments * 0.5 / 255;
  if (format == "rgba16") return segments * 0.5 / 65535;
  if (format == "rgba16f") return kKappa * 2 * std::sqrt(3.0) * 0x1p-12 + segments * 0x1p-25;
  return 0;
}

class KBufferClosedForm : public FramebufferFetch {};

TEST_P(KBufferClosedForm, ConstantBoxFromSeveralSidesAtEveryK) {
  const TransferFile transfer(constantTransfer(kKappa));
  for (auto projection : {Projection::perspective, Projection::orthographic})
    for (auto [azimuth, elevation] : {std::pair{30.0, 20.0}, {-140.0, -65.0}, {0.0, 0.0}, {45.0, 35.26438968}})
      for (int k = 1; k <= 14; ++k) {
        Scene scene = smallScene(transfer.path());
        scene.camera.projection = projection;
        scene.camera.azimuth = azimuth;
        scene.camera.elevation = elevation;
        scene.k = k;
        const Drawing drawing = draw(*device_, scene, constantBox());
        const Difference difference = againstBox(drawing);
        EXPECT_LE(difference.maximum, kFloat)
            << "k " << k << ", view " << azimuth << "," << elevation << ": " << difference;
        EXPECT_GT(difference.compared, 10000u);
      }
}

TEST_P(KBufferClosedForm, ConstantBoxFromSeveralSidesByEveryMethod) {
  const TransferFile transfer(constantTransfer(kKappa));
  for (Scene& scene : byEveryMethod(smallScene(transfer.path())))
    for (auto projection : {Projection::perspective, Projection::orthographic})
      for (auto [azimuth, elevation] : {std::pair{30.0, 20.0}, {-140.0, -65.0}, {0.0, 0.0}, {45.0, 35.26438968}}) {
        scene.camera.projection = projection;
        scene.camera.azimuth = azimuth;
        scene.camera.elevation = elevation;
        const Difference difference = againstBox(draw(*device_, scene, constantBox()));
        EXPECT_LE(difference.maximum, kFloat)
            << scene.visibility << ", view " << azimuth << "," << elevation << ": " << difference;
        EXPECT_GT(difference.compared, 10000u);
      }
}

TEST_P(KBufferClosedForm, ConstantBoxWithEveryLookup) {
  const TransferFile transfer(constantTransfer(kKappa));
  for (const VisibilityMethod& method : visibilityMethods())
    for (const Lookup& row : lookups())
      for (auto projection : {Projection::perspective, Projection::orthographic})
        // A lookup sees segments, not k: one k for all but the first, as each program takes a second to be compiled.
        for (int k : row.name == lookups().front().name ? std::vector{1, 2, 6, 14} : std::vector{6}) {
          if (k != 6 && method.maximumK == 0) continue;
          Scene scene = smallScene(transfer.path());
          scene.visibility = method.name;
          if (row.carries == Payload::color && !method.carriesColors) continue;
          scene.lookup = exampleName(row);
          scene.camera.projection = projection;
          scene.k = std::min(k, largestK(scene, {}));
          const Drawing drawing = draw(*device_, scene, constantBox());
          EXPECT_LE(againstBox(drawing).maximum, lookupBound(drawing, scene))
              << method.name << ", " << row.name << ", k " << k;
        }
}

TEST_P(KBufferClosedForm, ConstantBoxWithEveryTableFormat) {
  const TransferFile transfer(constantTransfer(kKappa));
  for (const Lookup& row : lookups())
    for (const TableFormat& format : tableFormats()) {
      if (!tableOf(row)) continue;
      Scene scene = smallScene(transfer.path());
      scene.lookup = row.name;
      scene.tableFormat = format.name;
      const Drawing drawing = draw(*device_, scene, constantBox());
      EXPECT_LE(againstBox(drawing).maximum, lookupBound(drawing, scene) + roundingOf(format.name))
          << row.name << " " << format.name;
    }
}

TEST_P(KBufferClosedForm, TheSmallestScalarIsDrawnAsAnyOther) {
  const TransferFile transfer(constantTransfer(kKappa));
  for (const Scene& scene : byEveryMethod(smallScene(transfer.path())))
    for (double value : {0.0, 1.0}) {
      const Drawing drawing = draw(*device_, scene, constantBox(value));
      EXPECT_LE(againstBox(drawing).maximum, kFloat) << scene.visibility << ", field " << value;
    }
}

TEST_P(KBufferClosedForm, ColourIsPremultiplied) {
  const TransferFile transfer(constantTransfer(kKappa, "[0.8, 0.4, 0.2]"));
  for (const Scene& scene : byEveryMethod(smallScene(transfer.path()))) {
    const Drawing drawing = draw(*device_, scene, constantBox());
    for (std::size_t i = 0; i < drawing.image.rgba.size(); i += 4) {
      const float alpha = drawing.image.rgba[i + 3];
      ASSERT_NEAR(drawing.image.rgba[i], 0.8f * alpha, kFloat) << scene.visibility;
      ASSERT_NEAR(drawing.image.rgba[i + 1], 0.4f * alpha, kFloat) << scene.visibility;
      ASSERT_NEAR(drawing.image.rgba[i + 2], 0.2f * alpha, kFloat) << scene.visibility;
    }
  }
}

// Kappa = s per unit and s linear along one axis: the optical depth is L times the mean of s over the ray, with `post`
// (trapezoid) exact.
TEST_P(KBufferClosedForm, LinearRamp) {
  const TransferFile transfer(R"({"version": 1, "opacity": "extinction", "unit_length": 1, "domain": [0, 1], "points": [
    {"scalar": 0, "color": [1, 1, 1], "opacity": 0}, {"scalar": 1, "color": [1, 1, 1], "opacity": 1}]})");
  TetMesh mesh = box(kBoxEdge, Cut::six, 0.2);
  auto values = linearField(mesh.points, {0.1, 0.35, 0.05});  // within [0, 1] on [-1, 1]^3
  mesh = withPointField(std::move(mesh), std::move(values));
  for (const Scene& scene : byEveryMethod(smallScene(transfer.path()))) {
    const Drawing drawing = draw(*device_, scene, mesh);
    const Difference difference = againstOpacity(drawing, [&](int x, int y) {
      const Ray ray = rayOf(drawing, x, y);
      const auto [first, last] = throughBox(ray, Vec3(-1.0), Vec3(1.0));
      if (last <= first) return 0.0;
      const Vec3 middle = ray.origin + 0.5 * (first + last) * ray.direction;
      return opacityOf(last - first, 0.5 + dot(Vec3(0.1, 0.35, 0.05), middle));
    });
    // The ramp is sampled at 4096 texels, between which it is linear: nothing is lost. Scalars interpolated in float.
    EXPECT_LE(difference.maximum, 2e-5) << scene.visibility << ": " << difference;
  }
}

TEST_P(KBufferClosedForm, CellDataIsConstantInEachCell) {
  const TransferFile transfer(R"({"version": 1, "opacity": "extinction", "unit_length": 1, "domain": [0, 1], "points": [
    {"scalar": 0, "color": [1, 1, 1], "opacity": 0}, {"scalar": 1, "color": [1, 1, 1], "opacity": 1}]})");
  TetMesh mesh = box(kBoxEdge);
  Field field{"c", 1, {}};
  for (const Tetrahedron& cell : mesh.tetrahedra) {
    double x = 0;
    for (Index p : cell) x += mesh.points[p].x;
    field.values.push_back(x < 0 ? 0.25 : 0.75);  // halves of the box: the plane x = 0 is one of the grid's
  }
  mesh.cellFields = {field};
  for (const Scene& scene : byEveryMethod(smallScene(transfer.path()))) {
    const Drawing drawing = draw(*device_, scene, mesh);
    const Difference difference = againstOpacity(drawing, [&](int x, int y) {
      const Ray ray = rayOf(drawing, x, y);
      const double depth =
          0.25 * lengthInBox(ray, {-1, -1, -1}, {0, 1, 1}) + 0.75 * lengthInBox(ray, {0, -1, -1}, {1, 1, 1});
      return opacityOf(depth, 1.0);
    });
    EXPECT_LE(difference.maximum, kFloat) << scene.visibility << ": " << difference;
  }
}

// Boundaries that touch, gaps, shells inside shells, a seam: entries and exits a rounding apart must not lose or add a
// segment.
TEST_P(KBufferClosedForm, TouchingAndNestedBoundaries) {
  const TransferFile transfer(constantTransfer(kKappa));
  struct Case {
    std::string name;
    TetMesh mesh;
    std::function<double(const Ray&)> length;
  };
  auto boxes = [](const Ray& ray, double gap) {
    return lengthInBox(ray, {-1, -1, -1}, {0, 1, 1}) + lengthInBox(ray, {gap, -1, -1}, {1 + gap, 1, 1});
  };
  auto cube = [](const Ray& ray, double half) { return lengthInBox(ray, Vec3(-half), Vec3(half)); };
  const double thinGap = 1e-4 * std::sqrt(3.0);  // 1e-4 radii
  std::vector<Case> cases;
  cases.push_back({"touching", twoBoxes(4, 0.0), [&](const Ray& ray) { return boxes(ray, 0.0); }});
  cases.push_back({"thin gap", twoBoxes(4, thinGap), [&](const Ray& ray) { return boxes(ray, thinGap); }});
  cases.push_back({"nested shells", nestedShells(10),
                   [&](const Ray& ray) { return cube(ray, 1.0) - cube(ray, 0.6) + cube(ray, 0.3); }});
  for (const Case& c : cases)
    for (auto [method, sort] : {std::pair{"kbuffer", "topological"},
                                {"kbuffer", "centroid"},
                                {"abuffer", "none"},
                                {"cells", "topological"}}) {
      Scene scene = smallScene(transfer.path());
      scene.visibility = method;
      scene.sort = sort;
      TetMesh mesh = c.mesh;
      auto values = constantField(mesh.points, 0.5);
      const Drawing drawing = draw(*device_, scene, withPointField(std::move(mesh), std::move(values)));
      const Difference difference = againstOpacity(
          drawing, [&](int x, int y) { return opacityOf(c.length(rayOf(drawing, x, y))); }, 1e-4);
      EXPECT_LE(difference.maximum, 1e-4) << c.name << ", " << method << ", " << sort << ": " << difference;
    }
}

TEST_P(KBufferClosedForm, EarlyTerminationStaysWithinItsOpacity) {
  const TransferFile transfer(constantTransfer(4.0));
  for (Scene& scene : byEveryMethod(smallScene(transfer.path()))) {
    const Drawing whole = draw(*device_, scene, constantBox());
    scene.earlyTermination = 0.9;
    if (!visibilityMethod(scene.visibility).endsPixelsEarly) {
      EXPECT_THROW(draw(*device_, scene, constantBox()), Error) << scene.visibility;
      continue;
    }
    const Drawing cut = draw(*device_, scene, constantBox());
    bool anyDiffers = false;
    for (std::size_t i = 3; i < whole.image.rgba.size(); i += 4) {
      const float a = whole.image.rgba[i], b = cut.image.rgba[i];
      ASSERT_LE(b, a + kFloat);
      ASSERT_GE(b, std::min(a, 0.9f) - kFloat);  // a pixel stops at 0.9 or later
      anyDiffers |= b < a - 1e-3f;
    }
    EXPECT_TRUE(anyDiffers) << scene.visibility;
  }
}

TEST_P(KBufferClosedForm, OpaquePlateauIsASurface) {
  // Transparent below 0.5, opacity 1 from there on: the picture shows the plane s = 0.5 where a ray meets it.
  const TransferFile transfer(R"({"version": 1, "opacity": "per_unit", "unit_length": 1, "domain": [0, 1], "points": [
    {"scalar": 0, "color": [0, 0, 1], "opacity": 0}, {"scalar": 0.5, "color": [0, 0, 1], "opacity": 0},
    {"scalar": 0.5, "color": [1, 0, 0], "opacity": 1}, {"scalar": 1, "color": [1, 0, 0], "opacity": 1}]})");
  TetMesh mesh = box(kBoxEdge, Cut::six, 0.2);
  auto values = linearField(mesh.points, {0.5, 0, 0});  // s = 0.5 at x = 0; s >= 0.5 in the half x >= 0
  for (Scene& scene : byEveryMethod(smallScene(transfer.path())))
    for (const Lookup& row : lookups()) {
      if (row.carries == Payload::color) continue;  // its fragments know no opaque surfaces
      // All methods call the same code for a segment: each lookup once.
      if (scene.visibility != Scene{}.visibility && row.name != lookups().front().name) continue;
      scene.lookup = exampleName(row);
      const Drawing drawing = draw(*device_, scene, withPointField(mesh, values));
      const auto mask = maskOf(drawing);
      std::size_t wrong = 0, opaque = 0;
      for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x) {
          if (mask[static_cast<std::size_t>(y * scene.width + x)]) continue;
          const double inside = lengthInBox(rayOf(drawing, x, y), {0, -1, -1}, {1, 1, 1});
          if (inside > 0 && inside < 1e-3) continue;  // the ray grazes the half: float may put it on either side
          const double expected = inside > 0 ? 1.0 : 0.0;
          opaque += expected > 0;
          wrong += std::abs(drawing.image.pixel(x, y)[3] - expected) > 1e-3;
        }
      EXPECT_EQ(wrong, 0u) << scene.visibility << ", " << row.name;
      EXPECT_GT(opaque, 500u);
    }
}

HAVS_FOR_EVERY_DEVICE(KBufferClosedForm);

}  // namespace
}  // namespace havs::test
