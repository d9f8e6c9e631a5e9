// Cells that show nothing are not drawn: the same picture without them, and an order as good as with them.
#include "scene/visible_part.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "gl/drawing.h"
#include "reference/reference_renderer.h"
#include "render/scene_sorter.h"
#include "support/gl_test.h"
#include "support/replay.h"

namespace havs::test {
namespace {

TetMesh smooth(TetMesh mesh) {
  auto values = smoothField(mesh.points);
  return withPointField(std::move(mesh), std::move(values));
}

struct Pair {
  havs::Drawing whole, part;
};

/// Drawn with all cells, and with those that show anything.
class TwoWays {
 public:
  TwoWays(const Device& device, const Scene& scene, TetMesh mesh)
      : prepared_(prepareScene(scene, std::move(mesh), stages_)),
        view_(viewOf(scene, prepared_)),
        plan_(plan(scene, prepared_.facts(), capabilitiesOf(device))) {}
  Pair draw() {
    return {plan_.way.make(prepared_, plan_, stages_, {})->draw(view_, stages_),
            makeRenderer(prepared_, plan_, stages_)->draw(view_, stages_)};
  }
  const PreparedScene& prepared() const { return prepared_; }
  const View& view() const { return view_; }

 private:
  StageTimes stages_;
  PreparedScene prepared_;
  View view_;
  RenderPlan plan_;
};

Scene sceneOf(const std::string& transferFunction, const std::string& visibility = "kbuffer") {
  Scene scene;
  scene.width = scene.height = 160;
  scene.transferFunction = transferFunction;
  scene.visibility = visibility;
  scene.lookup = "post";  // no table, and its programs are soon compiled
  scene.certificate = true;
  return scene;
}

class VisiblePart : public FramebufferFetch {};

// A cell that is left out adds nothing to a sum: the segments that are drawn are the same, to the bit where each cell
// finds its own ends. Where segments end at the next fragment, float distances on faces seen nearly edge on (off by up
// to 1e-3) may put a fragment of a clear cell before its neighbour's; it ended a segment too soon and is left out now.
// On the grids here that are up to 19 pixels of 25,600.
TEST_P(VisiblePart, GivesThePictureOfAllCells) {
  std::size_t fewer = 0, compared = 0;
  for (const char* transferFunction : {"three-peaks", "plateau-opaque"})
    for (const std::string visibility : {"kbuffer", "abuffer", "cells"})
      for (const TetMesh& mesh : {smooth(nestedShells(12)), smooth(stretchedLayers(10, 0.6))}) {
        TwoWays ways(*device_, sceneOf(transferFunction, visibility), mesh);
        const auto [whole, part] = ways.draw();
        const std::string what = fmt::format("{}, {}", transferFunction, visibility);
        ASSERT_FALSE(whole.drawnCells);
        fewer += part.drawnCells && *part.drawnCells < ways.prepared().mesh.tetrahedra.size() ? 1 : 0;
        if (visibility == "kbuffer") {  // cells count rounding across gaps
          EXPECT_LE(part.certificate->misordered, whole.certificate->misordered) << what;
        }
        if (whole.certificate->misordered > 0) continue;
        const Difference difference = between(part.image, whole.image, 1e-6);
        if (visibility == "cells") {
          EXPECT_EQ(difference.maximum, 0) << what << ": " << difference;
        }
        EXPECT_LE(difference.beyond, difference.compared / 1000) << what << ": " << difference;
        ++compared;
      }
  EXPECT_GE(fewer, 10u) << "transfer functions and meshes should leave cells out";
  EXPECT_GE(compared, 10u);
}

/// Root of the mean square over the pixels that the mask leaves.
double distance(const Image& a, const Image& b, const std::vector<unsigned char>& mask) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i)
    if (mask[i / 4] == 0) sum += std::pow(a.rgba[i] - b.rgba[i], 2);
  return std::sqrt(sum / static_cast<double>(a.rgba.size()));
}

// Where it differs from the picture of all cells, float distances have gone wrong either way: both are as far from the
// truth, to a hundredth.
TEST_P(VisiblePart, IsAsNearToTheTruth) {
  for (const char* transferFunction : {"three-peaks", "shells"}) {
    Scene scene = sceneOf(transferFunction);
    scene.lookup = "exact";
    TwoWays ways(*device_, scene, smooth(nestedShells(12)));
    const auto [whole, part] = ways.draw();
    StageTimes stages;
    const Image truth = makeReferenceRenderer(ways.prepared())->draw(ways.view(), stages).image;
    const auto mask = boundaryEdgeMask(ways.prepared().points, ways.prepared().faces, ways.view());
    EXPECT_LE(distance(part.image, truth, mask), 1.01 * distance(whole.image, truth, mask)) << transferFunction;
  }
}

// Where two faces lie at one place, as at the edges of a grid, rounding chooses which cell is behind them, and with
// cell data the whole next segment takes that cell's scalar: such pixels are wrong with all cells as with some, but not
// by the same. So both are held against the ground truth.
TEST_P(VisiblePart, IsNoFartherFromTheTruthForCellData) {
  TetMesh mesh = smooth(nestedShells(12));
  Field field{"c", 1, {}};
  for (const Tetrahedron& cell : mesh.tetrahedra) field.values.push_back(mesh.pointFields[0].values[cell[0]]);
  mesh.pointFields.clear();
  mesh.cellFields = {field};
  for (const char* visibility : {"kbuffer", "abuffer", "cells"}) {
    TwoWays ways(*device_, sceneOf("three-peaks", visibility), mesh);
    const auto [whole, part] = ways.draw();
    ASSERT_TRUE(part.drawnCells);
    StageTimes stages;
    const Image truth = makeReferenceRenderer(ways.prepared())->draw(ways.view(), stages).image;
    const auto mask = boundaryEdgeMask(ways.prepared().points, ways.prepared().faces, ways.view());
    const Difference ofWhole = between(whole.image, truth, 1e-4, mask), ofPart = between(part.image, truth, 1e-4, mask);
    EXPECT_LE(ofPart.beyond, ofWhole.beyond) << visibility << ": " << ofPart << ", with all cells " << ofWhole;
    EXPECT_LE(ofPart.beyond, ofPart.compared / 50) << visibility;
  }
}

/// Late fragments at k = 1 in the order that the visible part gives by itself, counted in double.
std::size_t lateByItself(const PreparedScene& whole, const View& view) {
  const PreparedScene part = *visiblePart(whole);
  FaceOrder order;
  makeSceneSorter(part, "topological", PartOrder::itsOwn)->sort(viewPointOf(view), order);
  return replay({part.points, &part.faces, order.faces, {}, view}, 1).misordered;
}

// Gaps hide which cell is in front. Where that makes fragments come late, the order of the whole mesh is taken.
TEST_P(VisiblePart, TakesTheOrderOfTheWholeMeshWhereItsOwnIsWrong) {
  std::size_t wrong = 0;
  for (const char* transferFunction : {"shells", "three-peaks"})
    for (const double azimuth : {10.0, 100.0, 190.0, 280.0}) {
      Scene scene = sceneOf(transferFunction);
      scene.k = 1;
      scene.camera.azimuth = azimuth;
      TetMesh mesh = box(14, Cut::six, 0.2);
      auto values = pointValues(mesh.points, [](const Vec3& p) {
        return 0.5 + 0.25 * std::sin(7 * p.x) * std::cos(5 * p.y) + 0.2 * std::sin(6 * p.z + 3 * p.x * p.y);
      });
      TwoWays ways(*device_, scene, withPointField(std::move(mesh), std::move(values)));
      const auto [whole, part] = ways.draw();
      EXPECT_LE(part.certificate->misordered, whole.certificate->misordered) << transferFunction << " " << azimuth;
      wrong += lateByItself(ways.prepared(), ways.view()) > 0 ? 1 : 0;
    }
  EXPECT_GE(wrong, 1u) << "no view shows what this test is about";
}

TEST_P(VisiblePart, DrawsTheSameWhetherLateFragmentsAreCountedOrFlagged) {
  Scene scene = sceneOf("shells");
  scene.k = 1;
  const TetMesh mesh = smooth(nestedShells(12));
  const Image counted = TwoWays(*device_, scene, mesh).draw().part.image;
  scene.certificate = false;
  EXPECT_EQ(TwoWays(*device_, scene, mesh).draw().part.image.rgba, counted.rgba);
}

TEST_P(VisiblePart, OfNothingIsAnEmptyPicture) {
  const TransferFile clear(constantTransfer(0));
  for (const char* visibility : {"kbuffer", "abuffer", "cells"}) {
    TwoWays ways(*device_, sceneOf(clear.path(), visibility), smooth(ball(4)));
    const auto [whole, part] = ways.draw();
    EXPECT_EQ(part.drawnCells, 0u);
    EXPECT_EQ(part.image.rgba, std::vector<float>(4 * 160 * 160, 0.0f));
    EXPECT_EQ(between(part.image, whole.image).maximum, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Devices, VisiblePart, testing::Values("osmesa"),
                         [](const auto& suiteInfo) { return suiteInfo.param; });

}  // namespace
}  // namespace havs::test
