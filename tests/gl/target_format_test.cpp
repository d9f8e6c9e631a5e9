// The k-buffer in targets of every number format: closed forms with the bound that the format's rounding gives.
#include <gtest/gtest.h>

#include <glm/gtc/packing.hpp>

#include "gl/captured_fragments.h"
#include "gl/drawing.h"
#include "support/gl_test.h"

namespace havs::test {
namespace {

constexpr double kKappa = 0.8;        // per mesh unit
constexpr double kFloat = 1e-5;       // float distances and 100 segments composited in float
constexpr double kHalf = 1.0 / 4096;  // rounding of a half in [1/2, 1)

class TargetFormats : public FramebufferFetch {};

Scene smallScene(const std::string& transfer, const std::string& format) {
  Scene scene;
  scene.transferFunction = transfer;
  scene.width = 120;
  scene.height = 90;
  scene.lookup = "post";
  scene.targetFormat = format;
  return scene;
}

/// Lengths of successive segments telescope, so that a stretch of the ray is off by the rounding of its ends (below 2
/// radii), in halves 2 kHalf each; the opacity is rounded once a segment.
double boundOf(const TargetFormat& format, double localKappa, int stretches, int mostSegments) {
  return kFloat + (format.halfFloats ? stretches * 2 * 2 * kHalf * localKappa + mostSegments * kHalf : 0.0);
}

TEST_P(TargetFormats, ConstantBox) {
  const TransferFile transfer(constantTransfer(kKappa));
  constexpr int kEdge = 4;
  for (const TargetFormat& format : targetFormats())
    for (int k : {1, 2, 3, 6, 14}) {
      Scene scene = smallScene(transfer.path(), format.name);
      scene.k = k;
      TetMesh mesh = box(kEdge, Cut::six, 0.2);
      auto values = constantField(mesh.points, 0.5);
      const Drawing drawing = draw(*device_, scene, withPointField(std::move(mesh), std::move(values)));
      const Difference difference = againstOpacity(drawing, [&](int x, int y) {
        return -std::expm1(-kKappa * lengthInBox(rayOf(drawing, x, y), Vec3(-1.0), Vec3(1.0)));
      });
      // Planes of the grid and of the six cuts, three families each way.
      EXPECT_LE(difference.maximum, boundOf(format, kKappa * drawing.prepared.frame.radius, 1, 3 * 6 * kEdge))
          << format.name << ", k " << k << ": " << difference;
    }
}

// Kinds and inside-counts ride in the free bits of halves, too.
TEST_P(TargetFormats, ShellsInsideShells) {
  const TransferFile transfer(constantTransfer(kKappa));
  for (const TargetFormat& format : targetFormats())
    for (const char* sort : {"topological", "centroid"}) {
      Scene scene = smallScene(transfer.path(), format.name);
      scene.sort = sort;
      scene.k = 8;
      TetMesh mesh = nestedShells(1);
      auto values = constantField(mesh.points, 1.0);
      const Drawing drawing = draw(*device_, scene, withPointField(std::move(mesh), std::move(values)));
      const Difference difference = againstOpacity(drawing, [&](int x, int y) {
        const Ray ray = rayOf(drawing, x, y);
        auto cube = [&](double half) { return lengthInBox(ray, Vec3(-half), Vec3(half)); };
        return -std::expm1(-kKappa * (cube(1.0) - cube(0.6) + cube(0.3)));
      });
      const double bound = boundOf(format, kKappa * drawing.prepared.frame.radius, 3, 3 * 6 * 6) +
                           (format.halfFloats ? 0.0 : 1e-4);  // as without formats: kbuffer_closed_form_test.cpp
      EXPECT_LE(difference.maximum, bound) << format.name << ", " << sort << ": " << difference;
    }
}

TEST_P(TargetFormats, PictureHoldsNumbersOfTheFormat) {
  const TransferFile transfer(constantTransfer(kKappa));
  for (const TargetFormat& format : targetFormats()) {
    TetMesh mesh = box(3);
    auto values = constantField(mesh.points, 0.5);
    const Drawing drawing = draw(*device_, smallScene(transfer.path(), format.name), withPointField(mesh, values));
    std::size_t halves = 0, seen = 0;
    for (const float value : drawing.image.rgba) {
      if (value == 0) continue;
      ++seen;
      halves += glm::unpackHalf1x16(glm::packHalf1x16(value)) == value;
    }
    EXPECT_GT(seen, 5000u);
    if (format.halfFloats) {
      EXPECT_EQ(halves, seen);
    } else {
      EXPECT_LT(halves, seen / 2);
    }
  }
}

TEST_P(TargetFormats, BytesOfAPixelAreThoseOfItsTargets) {
  Scene scene;
  for (const TargetFormat& format : targetFormats())
    for (int k : {1, 2, 5, 6, 14}) {
      scene.targetFormat = format.name;
      scene.k = k;
      const RenderPlan chosen = plan(scene, {}, capabilitiesOf(*device_));
      EXPECT_EQ(chosen.bytesPerPixel, (format.halfFloats ? 8 : 16) * (1 + (k + 1) / 2));
    }
}

// Late is what is late among the rounded distances, by more than their step.
TEST_P(TargetFormats, CertificateCountsLateFragmentsOfTheRoundedDistances) {
  Scene scene;
  scene.width = 130;
  scene.height = 100;
  scene.certificate = true;
  scene.lookup = "post";
  TetMesh mesh = stretchedLayers(8, 1.8);
  auto values = smoothField(mesh.points);
  mesh = withPointField(std::move(mesh), std::move(values));
  for (const char* sort : {"centroid", "none"})
    for (const TargetFormat& format : targetFormats())
      for (int k : {1, 2, 3, 6, 14}) {
        scene.sort = sort;
        scene.targetFormat = format.name;
        scene.k = k;
        const Drawing drawing = draw(*device_, scene, mesh);
        const CapturedPicture picture = captureFragments(drawing.prepared, drawing.view, sort);
        std::vector<std::uint32_t> expected;
        for (const auto& fragments : picture)
          expected.push_back(countLate(format.halfFloats ? inHalves(fragments) : fragments, sort, k,
                                       format.halfFloats ? 1e-3f : 1e-6f));
        EXPECT_EQ(drawing.certificate->count, expected) << sort << ", " << format.name << ", k " << k;
        if (k <= 2) {
          EXPECT_GT(drawing.certificate->misordered, 0u);
        }
      }
}

HAVS_FOR_EVERY_DEVICE(TargetFormats);

}  // namespace
}  // namespace havs::test
