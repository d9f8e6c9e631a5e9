// The mesh's outline, boundary surface and wire frame where a picture says by itself what is right: before and behind
// the volume, on opaque bodies, without a volume, by every lookup; and what the plan holds of them.
#include <gtest/gtest.h>

#include <algorithm>

#include "gl/device.h"
#include "image/compare.h"
#include "image/native_scene.h"
#include "overlay/boundary_layers.h"
#include "reference/edge_mask.h"
#include "render/make_renderer.h"
#include "render/native/instruction_sets.h"
#include "support/gl_test.h"
#include "support/meshes.h"

namespace havs::test {
namespace {

/// Looks along z at [-1, 1]^3, which fogMesh fills.
Scene fogScene() {
  Scene scene;
  scene.width = scene.height = 64;
  scene.camera.projection = Projection::orthographic;
  scene.camera.azimuth = scene.camera.elevation = 0;
  scene.lookup = "exact";
  return scene;
}
TetMesh fogMesh(const std::function<double(const Vec3&)>& field = [](const Vec3&) { return 1.0; }) {
  TetMesh mesh = box(4);
  mesh.pointFields = {{"s", 1, pointValues(mesh.points, field)}};
  return mesh;
}

// Before the volume a layer, and one behind: what comes through the first goes through the fog to the second.
TEST(Overlays, LieBeforeAndBehindTheVolume) {
  Scene scene = fogScene();
  scene.overlays.surface = BoundarySurface{{0, 1, 0}, 0.25, false};
  const NativeScene drawn(scene, fogMesh());
  Scene plain = scene;
  plain.overlays = {};
  const Image fog = NativeScene(plain, fogMesh()).truth();
  for (const Image& picture : {drawn.draw().image, drawn.truth()})
    for (const int at : {20, 31, 40}) {
      const float *with = picture.pixel(at, at + 1), *without = fog.pixel(at, at + 1);
      const double through = 0.75, alpha = static_cast<double>(without[3]);
      ASSERT_GT(alpha, 0.1);
      EXPECT_NEAR(static_cast<double>(with[0]), through * static_cast<double>(without[0]), 1e-6);
      EXPECT_NEAR(static_cast<double>(with[3]), 0.25 + through * (alpha + (1 - alpha) * 0.25), 1e-6);
      EXPECT_NEAR(static_cast<double>(with[1]), 0.25 + through * (static_cast<double>(without[1]) + (1 - alpha) * 0.25),
                  1e-6);
    }
}

Scene fogBody(Scene scene) {
  scene.overlays = {};
  return scene;
}

// An opaque body's surface lies where the boundary does: the layer is before it in every pixel, whatever the rounding.
TEST(Overlays, SurfaceIsBeforeAnOpaqueBody) {
  Scene scene = fogScene();
  scene.camera.azimuth = 30;
  scene.camera.elevation = 20;
  scene.camera.projection = Projection::perspective;
  scene.overlays.surface = BoundarySurface{{1, 0, 1}, 1, false};
  const auto device = makeTestDevice("osmesa");
  scene.transferFunction = "plateau-opaque";
  scene.domain = {{0, 2}};  // the field's 1 is opaque
  const NativeScene drawn(scene, fogMesh());
  ASSERT_GT(NativeScene(fogBody(scene), fogMesh()).truth().pixel(32, 32)[1], 0.1f) << "the body alone is not magenta";
  const auto expectNoGreen = [&](const Image& picture, const std::vector<unsigned char>& mask) {
    std::size_t seen = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
      if (!mask.empty() && mask[i / 4] != 0) continue;
      seen += picture.rgba[i] > 0 ? 1 : 0;
      EXPECT_LE(picture.rgba[i + 1], 1e-6f) << i / 4;  // OpenGL keeps opacities below 1 by 2^-24
    }
    EXPECT_GT(seen, 500u);
  };
  expectNoGreen(drawn.truth(), {});
  expectNoGreen(drawn.draw().image, {});
  const auto mask = boundaryEdgeMask(drawn.prepared.points, drawn.prepared.faces, drawn.view);
  for (const char* method : {"kbuffer", "abuffer"}) {
    scene.visibility = method;
    StageTimes stages;
    const RenderPlan chosen = plan(scene, drawn.prepared.facts(), capabilitiesOf(*device));
    expectNoGreen(makeRenderer(drawn.prepared, chosen, stages)->draw(drawn.view, stages).image, mask);
  }
}

Scene everything() {
  Scene scene = fogScene();
  scene.camera.azimuth = 30;
  scene.overlays = {Outline{}, BoundarySurface{}, WireFrame{}};
  return scene;
}

// Where nothing of the volume shows, the layers do.
TEST(Overlays, ShowWithoutAVolume) {
  Scene scene = everything();
  scene.domain = {{5, 6}};
  scene.transferFunction = "three-peaks";
  const NativeScene drawn(scene, fogMesh());
  const Comparison native = compareImages(drawn.draw().image, drawn.truth());
  EXPECT_LE(native.rgba.max, 1e-6);
  EXPECT_EQ(drawn.draw().drawnCells, 0u);
  EXPECT_GT(drawn.draw().image.pixel(32, 32)[3], 0.3f);
  const auto device = makeTestDevice("osmesa");
  for (const char* method : {"kbuffer", "abuffer"}) {
    scene.visibility = method;
    StageTimes stages;
    const RenderPlan chosen = plan(scene, drawn.prepared.facts(), capabilitiesOf(*device));
    EXPECT_LE(compareImages(makeRenderer(drawn.prepared, chosen, stages)->draw(drawn.view, stages).image, drawn.truth())
                  .rgba.max,
              1e-6)
        << method;
  }
}

// Termination at 0.9 leaves out at most a tenth of what is behind.
TEST(Overlays, EndWithThePixel) {
  Scene scene = everything();
  scene.camera.projection = Projection::perspective;
  scene.unitLength = 1;
  const NativeScene drawn(scene, fogMesh());
  const Image truth = drawn.truth();
  scene.earlyTermination = 0.9;
  const Comparison native = compareImages(drawn.drawAs(scene).image, truth);
  EXPECT_GT(native.rgba.max, 1e-6);
  EXPECT_LE(native.rgba.max, 0.1);
  const auto device = makeTestDevice("osmesa");
  for (const char* method : {"kbuffer", "abuffer"}) {
    scene.visibility = method;
    StageTimes stages;
    const RenderPlan chosen = plan(scene, drawn.prepared.facts(), capabilitiesOf(*device));
    EXPECT_LE(
        compareImages(makeRenderer(drawn.prepared, chosen, stages)->draw(drawn.view, stages).image, truth).rgba.max,
        0.1)
        << method;
  }
}

TEST(Overlays, AreTheSameBitsWithEveryInstructionSetAndK) {
  Scene scene = everything();
  scene.camera.projection = Projection::perspective;
  const NativeScene drawn(scene, withSmoothPoints(nestedShells(4)));
  const havs::Drawing first = drawn.draw();
  for (const InstructionSet& set : instructionSets()) {
    if (!set.available()) continue;
    scene.instructionSet = set.name;
    EXPECT_EQ(differenceInBits(first, drawn.drawAs(scene)), "") << set.name;
  }
  scene.k = 9;
  EXPECT_EQ(differenceInBits(first.image, drawn.drawAs(scene).image), "");
  EXPECT_EQ(differenceInBits(first.image, drawn.drawAs(scene, [](RenderPlan& plan) { plan.speculate = false; }).image),
            "");
}

/// The plain picture of a convex mesh between the layers where rays enter and leave it.
Image betweenLayers(const Image& plain, const RayLayers& layers) {
  Image image = plain;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto found = layers.at(x, y);
      std::array<float, 4> sum{};
      const auto under = [&](const float* color) {
        const float through = 1 - sum[3];
        for (std::size_t c = 0; c < 4; ++c) sum[c] += through * color[c];
      };
      if (!found.empty()) under(found.front().rgba.data());
      under(plain.pixel(x, y));
      if (found.size() > 1) under(found.back().rgba.data());
      std::copy(sum.begin(), sum.end(), image.pixel(x, y));
    }
  return image;
}

// By every lookup, of point data and cell data: before and behind what is drawn without layers.
TEST(Overlays, LieAroundTheVolumeByEveryLookup) {
  const auto device = makeTestDevice("osmesa");
  Scene scene = everything();
  scene.overlays.outline.reset();
  scene.tableSize = 32;
  for (const auto& [mesh, projection] : {std::pair(withSmoothPoints(box(5, Cut::five)), Projection::perspective),
                                         std::pair(withSmoothCells(box(5, Cut::five)), Projection::orthographic)}) {
    scene.camera.projection = projection;
    const NativeScene drawn(scene, mesh);
    const RayLayers layers = BoundaryLayers(drawn.prepared, scene.overlays).of(drawn.view);
    const auto mask = boundaryEdgeMask(drawn.prepared.points, drawn.prepared.faces, drawn.view);
    for (const Lookup& row : lookups()) {
      Scene with = scene;
      with.lookup = exampleName(row);
      Scene without = with;
      without.overlays = {};
      const Image expected = betweenLayers(drawn.drawAs(without).image, layers);
      EXPECT_LE(compareImages(drawn.drawAs(with).image, expected).rgba.max, 1e-6) << with.lookup;
      const auto onGl = [&](const Scene& asked) {
        StageTimes stages;
        const RenderPlan chosen = plan(asked, drawn.prepared.facts(), capabilitiesOf(*device));
        return makeRenderer(drawn.prepared, chosen, stages)->draw(drawn.view, stages).image;
      };
      EXPECT_LE(compareImages(onGl(with), betweenLayers(onGl(without), layers), mask).rgba.max, 1e-6) << with.lookup;
    }
  }
}

TEST(Overlays, DoNotDependOnOpenGlsTiles) {
  const auto device = makeTestDevice("osmesa");
  Scene scene = everything();
  const NativeScene drawn(scene, withSmoothPoints(nestedShells(4)));
  for (const char* method : {"kbuffer", "abuffer"}) {
    scene.visibility = method;
    StageTimes stages;
    RenderPlan chosen = plan(scene, drawn.prepared.facts(), capabilitiesOf(*device));
    const Image whole = makeRenderer(drawn.prepared, chosen, stages)->draw(drawn.view, stages).image;
    chosen.tileWidth = 27;
    chosen.tileHeight = 19;
    const Image tiled = makeRenderer(drawn.prepared, chosen, stages)->draw(drawn.view, stages).image;
    // A tile's own matrix rounds corners anew; layers in a wrong pixel would be off by their opacity.
    EXPECT_LE(compareImages(tiled, whole).rgba.p999, 1e-4) << method;
    EXPECT_LE(compareImages(tiled, whole).rgba.rmse, 1e-3) << method;
  }
}

std::vector<std::string> itemsOf(const RenderPlan& plan) {
  std::vector<std::string> names;
  for (const PlanItem& item : plan.items)
    if (item.stage == "layers" || item.stage == "outline") names.push_back(item.name + ": " + item.reason);
  return names;
}

TEST(OverlaysPlan, HoldsWhatIsAskedForAndNothingElse) {
  const auto device = makeTestDevice("osmesa");
  for (const Capabilities& machine : {capabilitiesOf(*device), Capabilities{.native = true}}) {
    Scene scene = fogScene();
    const RenderPlan plain = plan(scene, {}, machine);
    EXPECT_TRUE(itemsOf(plain).empty());
    EXPECT_FALSE(plain.layers || plain.overlays.any());
    scene.overlays.outline.emplace();
    const RenderPlan outlined = plan(scene, {}, machine);
    EXPECT_EQ(itemsOf(outlined).size(), 1u);
    EXPECT_FALSE(outlined.layers) << "the outline lies outside the volume";
    EXPECT_EQ(outlined.defines.size(), plain.defines.size());
    EXPECT_EQ(outlined.bytesPerPixel, plain.bytesPerPixel);
    scene.overlays = {{}, BoundarySurface{}, WireFrame{}};
    const RenderPlan layered = plan(scene, {}, machine);
    EXPECT_EQ(itemsOf(layered).size(), 2u);
    EXPECT_TRUE(layered.layers && layered.overlays.surface && layered.overlays.wireFrame);
    EXPECT_FALSE(layered.overlays.outline || layered.opaqueLayers);
    EXPECT_EQ(layered.defines.size(), plain.defines.size() + 1);
    EXPECT_EQ(layered.bytesPerPixel, plain.bytesPerPixel + (machine.native ? 8 : 0)) << "the next layer, and the end";
    EXPECT_EQ(largestK(scene, machine), largestK(fogScene(), machine));
  }
}

}  // namespace
}  // namespace havs::test
