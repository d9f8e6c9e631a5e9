#include "image/against_reference.h"

#include <algorithm>
#include <filesystem>

#include "image/difference_picture.h"
#include "reference/edge_mask.h"
#include "reference/reference_renderer.h"
#include "render/make_renderer.h"
#include "support/gl_test.h"
#include "support/pixel_trace.h"
#include "transfer/transfer_function.h"

namespace havs::test {
namespace {

double errorAt(const Pair& pair, std::size_t pixel) {
  double error = 0;
  for (std::size_t c = 4 * pixel; c < 4 * pixel + 4; ++c)
    error = std::max<double>(error, std::abs(pair.picture.image.rgba[c] - pair.truth.rgba[c]));
  return error;
}

/// A folder of the running test's own below the build's.
std::filesystem::path failureFolder() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "." + info->name();
  std::replace(name.begin(), name.end(), '/', '.');
  return std::filesystem::path(HAVS_BUILD) / "failed-images" / name;
}

void writePictures(const Pair& pair) {
  const std::filesystem::path folder = failureFolder();
  std::filesystem::create_directories(folder);
  writeImage(pair.picture.image, folder / "picture.png");
  writeImage(pair.truth, folder / "reference.png");
  writeImage(pair.picture.image, folder / "picture.exr");
  writeImage(pair.truth, folder / "reference.exr");
  const DifferenceStyle style{.colors = presetColors("inferno")};
  writeImage(differencePicture(pair.picture.image, pair.truth, pair.mask, style).image, folder / "difference.png");
  std::cout << "picture, reference and difference are in " << folder.string() << '\n';
}

}  // namespace

void AgainstReference::SetUp() {
  auto mesh = GetParam().make();
  if (!mesh) GTEST_SKIP() << "no such mesh here: TetGen is left out of the build, or there is no " << HAVS_SHARED_DATA;
  mesh_ = std::move(*mesh);
  device_ = makeTestDevice("osmesa");
}

void AgainstReference::TearDown() {
  if (HasFailure() && last_) writePictures(*last_);
}

const Pair& AgainstReference::draw(Scene scene) {
  scene.width = scene.height = GetParam().size;
  StageTimes stages;
  last_ = std::make_unique<Pair>(Pair{.prepared = prepareScene(scene, mesh_, stages)});
  Pair& pair = *last_;
  pair.view = makeView(scene.camera, pair.prepared.frame, scene.width, scene.height);
  const RenderPlan chosen = plan(scene, pair.prepared.facts(), capabilitiesOf(*device_));
  pair.picture = makeRenderer(pair.prepared, chosen, stages)->draw(pair.view, stages);
  pair.truth = makeReference(scene, pair.prepared)->draw(pair.view, stages).image;
  pair.mask = boundaryEdgeMask(pair.prepared.points, pair.prepared.faces, pair.view);
  pair.comparison = compareImages(pair.picture.image, pair.truth, pair.mask);
  return pair;
}

std::vector<std::size_t> pixelsBeyond(double limit, const Pair& pair) {
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i < pair.mask.size(); ++i)
    if (!pair.mask[i] && !(errorAt(pair, i) <= limit)) pixels.push_back(i);
  return pixels;
}

void AgainstReference::expectEachTraced(double limit) const {
  const Pair& pair = *last_;
  const auto pixels = pixelsBeyond(limit, pair);
  ASSERT_LE(pixels.size(), 300u) << "too many to trace";
  const PixelTracer tracer(pair.prepared, pair.view);
  const auto width = static_cast<std::size_t>(pair.view.width);
  for (const std::size_t pixel : pixels) {
    const std::size_t late = pair.picture.certificate ? pair.picture.certificate->count[pixel] : 0;
    const PixelTrace trace = tracer.trace(static_cast<int>(pixel % width), static_cast<int>(pixel / width),
                                          pair.picture.image, pair.truth, late);
    for (std::size_t c = 0; c < 4; ++c)  // up to the reference's rounding to float
      EXPECT_NEAR(trace.exact.color[c], double{pair.truth.rgba[4 * pixel + c]}, 1e-7) << summary(trace);
    EXPECT_TRUE(trace.cause == Cause::grid || trace.cause == Cause::rounding)
        << summary(trace) << listOf(trace.exact) << " the rasteriser:\n"
        << listOf(trace.snapped);
  }
}

}  // namespace havs::test
