// Pixels that take no more fragments are spared the shader (render/gl/done_pixels.h): the same picture.
#include <gtest/gtest.h>

#include "gl/drawing.h"
#include "reference/reference_renderer.h"
#include "support/gl_test.h"

namespace havs::test {
namespace {

/// More faces than several batches have, as pixels are looked for between batches.
TetMesh manyFaces() {
  TetMesh mesh = box(20, Cut::six, 0.2);
  auto values = smoothField(mesh.points);
  return withPointField(std::move(mesh), std::move(values));
}

Scene sceneOf(const std::string& transferFunction, double earlyTermination) {
  Scene scene;
  scene.width = scene.height = 96;
  scene.transferFunction = transferFunction;
  scene.lookup = "post";
  scene.earlyTermination = earlyTermination;
  return scene;
}

std::string dense() {
  return R"({"version": 1, "points": [{"scalar": 0, "color": [0.1, 0.6, 0.3], "opacity": 0.5},
                                      {"scalar": 1, "color": [0.9, 0.2, 0.3], "opacity": 0.9}]})";
}

class DonePixels : public FramebufferFetch {};

// A certificate counts fragments of all pixels that are looked at: there nothing is marked, every fragment finds out by
// itself that its pixel is done.
TEST_P(DonePixels, AreTheSameWithAndWithoutMarks) {
  const TransferFile file(dense());
  const TetMesh mesh = manyFaces();
  for (const double terminal : {0.5, 0.9, 0.999}) {
    Scene scene = sceneOf(file.path(), terminal);
    const Drawing marked = draw(*device_, scene, mesh);
    ASSERT_GE(marked.prepared.faces.size(), 3u * 32768) << "too few faces for a mark";
    scene.certificate = true;
    const Drawing counted = draw(*device_, scene, mesh);
    EXPECT_EQ(marked.image.rgba, counted.image.rgba) << terminal;
    std::size_t done = 0;
    for (std::size_t i = 3; i < marked.image.rgba.size(); i += 4)
      done += marked.image.rgba[i] >= static_cast<float>(terminal) ? 1 : 0;
    EXPECT_GT(done, 1000u) << "no pixel is done";
  }
}

// Behind an opaque surface a k-buffer without marks goes on compositing what shines through the last bit of opacity,
// 6e-8 of it a segment, up to a hundred segments.
TEST_P(DonePixels, BehindOpaqueSurfacesShowNothing) {
  const TetMesh mesh = manyFaces();
  Scene scene = sceneOf("plateau-opaque", 0);
  const Drawing marked = draw(*device_, scene, mesh);
  scene.certificate = true;
  const Drawing whole = draw(*device_, scene, mesh);
  const Difference difference = between(marked.image, whole.image, 1e-6);
  EXPECT_LE(difference.maximum, 100 * 6e-8) << difference;
  EXPECT_GT(marked.image.pixel(48, 48)[3], 0.9999f);
}

TEST(DonePixelsPlan, AreMarkedOnlyWhereAPixelMayBeDone) {
  Capabilities capabilities;
  capabilities.hasExtension = [](const std::string&) { return true; };
  Scene scene;
  const auto marks = [&](bool opaque) {
    SceneFacts facts;
    facts.opaqueSurfaces = opaque;
    const RenderPlan chosen = plan(scene, facts, capabilities);
    EXPECT_EQ(chosen.bytesPerPixel, 64 + (chosen.marksDonePixels ? 1 : 0));
    return chosen.marksDonePixels;
  };
  EXPECT_FALSE(marks(false));
  EXPECT_TRUE(marks(true));
  scene.earlyTermination = 0.9;
  EXPECT_TRUE(marks(false));
  scene.certificate = true;
  EXPECT_FALSE(marks(false));
  EXPECT_FALSE(marks(true));
}

INSTANTIATE_TEST_SUITE_P(Devices, DonePixels, testing::Values("osmesa", "egl"),
                         [](const auto& suiteInfo) { return suiteInfo.param; });

}  // namespace
}  // namespace havs::test
