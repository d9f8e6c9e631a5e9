// The native device against OpenGL, every lookup, both kinds of data: the same plan, order, tables and arithmetic. The
// rasteriser's grid of 1/256 pixel and its float planes stand between them, so that bounds are of 99.9% of the pixels
// outside the edge mask.
#include "gl/drawing.h"
#include "image/compare.h"
#include "render/devices.h"
#include "support/gl_test.h"
#include "support/lookup_names.h"

namespace havs::test {
namespace {

constexpr double kMost = 2e-5;

Image drawNative(const Scene& scene, const Drawing& drawn) {
  StageTimes stages;
  const RenderPlan chosen = plan(scene, drawn.prepared.facts(), openRenderDevice("native").capabilities);
  return makeRenderer(drawn.prepared, chosen, stages)->draw(drawn.view, stages).image;
}

TetMesh pointMesh() {
  TetMesh mesh = box(5, Cut::six, 0.25, 3);
  auto values = smoothField(mesh.points);
  return withPointField(std::move(mesh), std::move(values));
}

TetMesh cellMesh() {
  TetMesh mesh = box(4, Cut::six, 0.25, 3);
  std::vector<Vec3> centers;
  for (const Tetrahedron& cell : mesh.tetrahedra)
    centers.push_back(0.25 *
                      (mesh.points[cell[0]] + mesh.points[cell[1]] + mesh.points[cell[2]] + mesh.points[cell[3]]));
  mesh.cellFields = {Field{"c", 1, smoothField(centers)}};
  return mesh;
}

class NativeAgreement : public testing::TestWithParam<std::string> {
 protected:
  NativeAgreement() : device_(makeTestDevice("osmesa")) {
    scene_.width = scene_.height = 160;
    scene_.lookup = GetParam();
    if (tableOf(lookup(GetParam())) != nullptr) scene_.tableSize = 32;
  }

  void expectSame(const TetMesh& mesh) {
    const Drawing drawn = draw(*device_, scene_, mesh);
    const Comparison comparison = compareImages(drawNative(scene_, drawn), drawn.image, maskOf(drawn));
    EXPECT_GT(comparison.pixels, drawn.image.rgba.size() / 4 / 2);
    EXPECT_LE(comparison.rgba.p999, kMost);
  }

  std::unique_ptr<Device> device_;
  Scene scene_;
};

TEST_P(NativeAgreement, PointData) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    scene_.camera.projection = projection;
    expectSame(pointMesh());
  }
}

/// A pixel's centre within the grid's step of an inner edge may see another cell, and another value: outside such
/// pixels the pictures agree. Large cells have few of them.
TEST_P(NativeAgreement, CellData) {
  const Drawing drawn = draw(*device_, scene_, cellMesh());
  const Image native = drawNative(scene_, drawn);
  const Difference difference = between(native, drawn.image, kMost, maskOf(drawn));
  EXPECT_LE(static_cast<double>(difference.beyond), 0.05 * static_cast<double>(difference.compared)) << difference;
}

class NativeAgreementOfTables : public NativeAgreement {};

TEST_P(NativeAgreementOfTables, Rounded) {
  scene_.tableFormat = "rgba8";
  expectSame(pointMesh());
}

INSTANTIATE_TEST_SUITE_P(Lookups, NativeAgreement, testing::ValuesIn(lookupNames()),
                         [](const testing::TestParamInfo<std::string>& row) { return testName(row.param); });

INSTANTIATE_TEST_SUITE_P(Lookups, NativeAgreementOfTables, testing::ValuesIn(namesOfLookupsWithTables()),
                         [](const testing::TestParamInfo<std::string>& row) { return testName(row.param); });

}  // namespace
}  // namespace havs::test
