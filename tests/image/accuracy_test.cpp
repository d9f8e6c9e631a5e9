// The k-buffer against the reference where no table comes between them: what is left is float, and the rasteriser's
// grid of 1/256 pixel, which pixel by pixel explains what is beyond float.
#include <cmath>

#include "image/against_reference.h"
#include "support/temporary_folder.h"

namespace havs::test {
namespace {

/// One colour, and extinction that grows from 0 with the scalar: the trapezoidal rule (lookup `post`) is exact for it.
const std::string kFog = R"({"version": 1, "opacity": "extinction", "points": [
  {"scalar": 0, "color": [0.8, 0.4, 0.2], "opacity": 0}, {"scalar": 1, "color": [0.8, 0.4, 0.2], "opacity": 0.3}]})";

class Accuracy : public AgainstReference {};

/// A ray has some tens of segments, a hundred at most. Each may lose 2^-24 in the distances of its ends, of order 1,
/// and as much in compositing; 99.9% of the pixels stay below a hundred times 2^-24.
constexpr double kFloat = 6e-6;

TEST_P(Accuracy, FogByTheTrapezoidalRule) {
  const TemporaryFolder folder;
  Scene scene;
  scene.transferFunction = folder.write("fog.json", kFog).string();
  scene.lookup = "post";
  const Pair& pair = draw(scene);
  EXPECT_GT(pair.comparison.pixels, pair.mask.size() / 2);
  EXPECT_LE(pair.comparison.rgba.p999, kFloat);
  expectEachTraced(2 * kFloat);
}

/// The promise of the project: three steep peaks, integrated in the shader, at most 2e-5 in 99.9% of the pixels, at
/// most 50 pixels of a million beyond 1e-3. A peak's extinction goes from 0 to its top within 0.02 of the scalar, so
/// that roundings of the scalar count fifty times and more.
TEST_P(Accuracy, ThreePeaksIntegratedExactly) {
  Scene scene;
  scene.transferFunction = "three-peaks";
  scene.lookup = "exact";
  const Pair& pair = draw(scene);
  EXPECT_LE(pair.comparison.rgba.p999, 2e-5);
  EXPECT_LE(static_cast<double>(pixelsBeyond(1e-3, pair).size()),
            std::ceil(50e-6 * static_cast<double>(pair.mask.size())));
  expectEachTraced(2e-4);
}

TEST_P(Accuracy, OrthographicThreePeaks) {
  Scene scene;
  scene.transferFunction = "three-peaks";
  scene.lookup = "exact";
  scene.camera.projection = Projection::orthographic;
  scene.camera.azimuth = 200;
  scene.camera.elevation = -35;
  const Pair& pair = draw(scene);
  EXPECT_LE(pair.comparison.rgba.p999, 2e-5);
  expectEachTraced(2e-4);
}

INSTANTIATE_TEST_SUITE_P(Meshes, Accuracy, testing::ValuesIn(meshesDrawn()), nameOfMesh);

}  // namespace
}  // namespace havs::test
