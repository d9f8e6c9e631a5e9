// The visibility methods against each other: the same picture from lists of all fragments, from cells as they come, and
// from the k-buffer, wherever the order is certified; and what each of them promises for itself.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "core/error.h"
#include "gl/drawing.h"
#include "mesh/read.h"
#include "support/gl_test.h"
#include "support/replay.h"

namespace havs::test {
namespace {

TetMesh smooth(TetMesh mesh) {
  auto values = smoothField(mesh.points);
  return withPointField(std::move(mesh), std::move(values));
}

struct NamedMesh {
  std::string name;
  TetMesh mesh;
};

std::vector<NamedMesh> proceduralMeshes() {
  return {{"ball", smooth(ball(8))},
          {"nested shells", smooth(nestedShells(10))},
          {"O-grid", smooth(oGrid(6, 48, 6))},
          {"stretched layers", smooth(stretchedLayers(10, 0.6))},
          {"visibility cycle", smooth(visibilityCycle())},
          {"touching boxes", smooth(twoBoxes(4, 0.0))}};
}

Scene sceneBy(const std::string& method) {
  Scene scene;
  scene.width = scene.height = 160;
  scene.visibility = method;
  scene.tableSize = 32;  // the same for all: what it costs in accuracy does not show
  scene.certificate = true;
  return scene;
}

/// The q-quantile of the largest difference of a channel, over the pixels that the mask leaves.
double quantileBetween(const Image& a, const Image& b, const std::vector<unsigned char>& mask, double q) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i]) continue;
    double error = 0;
    for (std::size_t c = 0; c < 4; ++c)
      error = std::max<double>(error, std::abs(a.rgba[4 * i + c] - b.rgba[4 * i + c]));
    errors.push_back(error);
  }
  const auto place = errors.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(errors.size() - 1));
  std::nth_element(errors.begin(), place, errors.end());
  return *place;
}

/// Cell data from the point data at a cell's first point.
TetMesh withCellField(TetMesh mesh) {
  Field field{"c", 1, {}};
  for (const Tetrahedron& cell : mesh.tetrahedra) field.values.push_back(mesh.pointFields[0].values[cell[0]]);
  mesh.pointFields.clear();
  mesh.cellFields = {field};
  return mesh;
}

/// A scene prepared once, drawn by a plan that a test may change.
class Prepared {
 public:
  Prepared(const Device& device, const Scene& scene, TetMesh mesh)
      : prepared(prepareScene(scene, std::move(mesh), stages_)),
        view(makeView(scene.camera, prepared.frame, scene.width, scene.height)),
        chosen(plan(scene, prepared.facts(), capabilitiesOf(device))) {}
  havs::Drawing draw() { return makeRenderer(prepared, chosen, stages_)->draw(view, stages_); }

 private:
  StageTimes stages_;

 public:
  PreparedScene prepared;
  View view;
  RenderPlan chosen;
};

/// The a-buffer needs none of the extensions that the k-buffer does: it is tested on every device.
class ABuffer : public GlTest {};
class VisibilityAgreement : public FramebufferFetch {};

// The same fragments through the same arithmetic: where the k-buffer's order is right, no difference but that of ties.
TEST_P(VisibilityAgreement, ABufferIsTheKBufferWithEveryFragment) {
  for (const NamedMesh& named : proceduralMeshes())
    for (auto projection : {Projection::perspective, Projection::orthographic}) {
      Scene scene = sceneBy("kbuffer");
      scene.camera.projection = projection;
      scene.k = 14;
      const Drawing expected = draw(*device_, scene, named.mesh);
      scene.visibility = "abuffer";
      const Drawing drawing = draw(*device_, scene, named.mesh);
      ASSERT_TRUE(drawing.certificate);
      EXPECT_EQ(drawing.certificate->misordered, 0u);
      EXPECT_GT(drawing.certificate->fragments, 10000u) << named.name;
      const Difference difference = between(drawing.image, expected.image);
      EXPECT_LE(difference.maximum, 1e-5) << named.name << ": " << difference;
    }
}

// Cells meet faces by their own arithmetic: both ways are within float's error of what is right, which the k-buffer is
// tested for (1% of pixels beyond 2e-5, kbuffer_agreement_test.cpp).
TEST_P(VisibilityAgreement, CellsWhereTheirOrderIsCertified) {
  for (const NamedMesh& named : proceduralMeshes())
    for (auto projection : {Projection::perspective, Projection::orthographic}) {
      Scene scene = sceneBy("abuffer");
      scene.camera.projection = projection;
      const Drawing expected = draw(*device_, scene, named.mesh);
      scene.visibility = "cells";
      const Drawing drawing = draw(*device_, scene, named.mesh);
      ASSERT_TRUE(drawing.certificate);
      const Certificate& certificate = *drawing.certificate;
      auto mask = maskOf(drawing);
      for (std::size_t i = 0; i < mask.size(); ++i) mask[i] |= certificate.count[i] > 0;
      EXPECT_LE(quantileBetween(drawing.image, expected.image, mask, 0.999), 2e-5) << named.name;
      const bool hasCycles = named.name == "visibility cycle";
      // Non-convex meshes: the topological order may misplace single fragments of a part (docs/02-method.md).
      EXPECT_LE(certificate.misordered, certificate.fragments / (hasCycles ? 10 : 1000)) << named.name;
      EXPECT_GT(certificate.fragments, 5000u) << named.name;
    }
}

TEST_P(VisibilityAgreement, CertificateOfCellsSeesAWrongOrder) {
  Scene scene = sceneBy("cells");
  const Drawing ordered = draw(*device_, scene, smooth(ball(8)));
  EXPECT_EQ(ordered.certificate->misordered, 0u);  // convex, without cycles: exact
  scene.sort = "none";
  const Drawing any = draw(*device_, scene, smooth(ball(8)));
  EXPECT_GT(any.certificate->misordered, any.certificate->fragments / 10);
  EXPECT_EQ(any.certificate->fragments, ordered.certificate->fragments);
  std::size_t sum = 0, pixels = 0;
  for (const std::uint32_t count : any.certificate->count) {
    sum += count;
    pixels += count > 0;
  }
  EXPECT_EQ(sum, any.certificate->misordered);
  EXPECT_EQ(pixels, any.certificate->pixels);
}

TEST_P(VisibilityAgreement, CellDataAndOpaqueSurfaces) {
  const TransferFile opaque(R"({"version": 1, "opacity": "per_unit", "unit_length": 1, "domain": [0, 1], "points": [
    {"scalar": 0, "color": [0, 0, 1], "opacity": 0}, {"scalar": 0.6, "color": [0, 1, 0], "opacity": 0.4},
    {"scalar": 0.6, "color": [1, 0, 0], "opacity": 1}, {"scalar": 1, "color": [1, 1, 0], "opacity": 1}]})");
  const TetMesh pointData = smooth(ball(8));
  for (const TetMesh& mesh : {pointData, withCellField(pointData)})
    for (const std::string& transfer : {std::string("viridis"), opaque.path()}) {
      Scene scene = sceneBy("kbuffer");
      scene.transferFunction = transfer;
      const Drawing expected = draw(*device_, scene, mesh);
      const bool cellData = expected.prepared.facts().cellData;
      for (const char* method : {"abuffer", "cells"}) {
        scene.visibility = method;
        const Drawing drawing = draw(*device_, scene, mesh);
        EXPECT_LE(quantileBetween(drawing.image, expected.image, maskOf(drawing), 0.999), 2e-5)
            << method << ", " << (cellData ? "cells" : "points") << ", " << transfer;
      }
    }
}

TEST_P(ABuffer, IsTheSameTwiceAndWhateverTheTiles) {
  const Scene scene = sceneBy("abuffer");
  Prepared prepared(*device_, scene, smooth(ball(8)));
  const havs::Drawing whole = prepared.draw();
  EXPECT_EQ(whole.tiles, 1u);
  EXPECT_EQ(whole.fragmentBytes, 8 * whole.fragments);
  EXPECT_EQ(prepared.draw().image.rgba, whole.image.rgba);
  // The second cuts single rows: a row of the ball's middle has some 8,000 fragments.
  for (const std::size_t most : {whole.fragments / 5, std::size_t{3000}}) {
    prepared.chosen.mostFragments = most;
    const havs::Drawing tiled = prepared.draw();
    EXPECT_GE(tiled.tiles, whole.fragments / most);
    EXPECT_LE(tiled.fragmentBytes, 8 * most);
    EXPECT_EQ(tiled.fragments, whole.fragments);
    EXPECT_EQ(tiled.image.rgba, whole.image.rgba) << most << " fragments a tile";
  }
}

TEST_P(ABuffer, DoesNotDependOnTheOrderOfTheFaces) {
  Prepared prepared(*device_, sceneBy("abuffer"), smooth(ball(8)));
  const Image numbered = prepared.draw().image;
  Faces& faces = prepared.prepared.faces;
  std::vector<std::size_t> order(faces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(5));
  const Faces former = faces;
  for (std::size_t f = 0; f < order.size(); ++f) {
    faces.vertices[f] = former.vertices[order[f]];
    faces.cells[f] = former.cells[order[f]];
  }
  EXPECT_EQ(prepared.draw().image.rgba, numbered.rgba);
}

TEST_P(ABuffer, RefusesAPixelWithMoreFragmentsThanFit) {
  Prepared prepared(*device_, sceneBy("abuffer"), smooth(ball(8)));
  prepared.chosen.mostFragments = 10;
  try {
    prepared.draw();
    FAIL() << "drawn";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("--visibility"), std::string::npos) << error.what();
  }
}

// Two layers of large triangles in front of many small ones: what llvmpipe would drop of opaque triangles
// (docs/llvmpipe.md). A slab that fills the picture: 12 layers of cells, each face of which covers many 64 x 64 tiles.
TEST_P(ABuffer, KeepsWhatLiesBehindTrianglesThatCoverWholeTiles) {
  constexpr int kLayers = 12;
  const TetMesh slab = gridMesh(1, 1, kLayers, Cut::six, [](int i, int j, int k) {
    return Vec3(4.0 * i - 2.0, 4.0 * j - 2.0, static_cast<double>(k) / kLayers);
  });
  const TransferFile transfer(constantTransfer(1.0));
  Scene scene = sceneBy("abuffer");
  scene.transferFunction = transfer.path();
  scene.lookup = "post";
  scene.width = scene.height = 256;
  scene.camera.azimuth = scene.camera.elevation = 0;
  scene.camera.zoom = 3;  // a third of the bounding sphere: the slab reaches beyond the picture
  scene.camera.projection = Projection::orthographic;
  const Drawing drawing = draw(*device_, scene, withPointField(slab, constantField(slab.points, 0.5)));
  for (std::size_t i = 3; i < drawing.image.rgba.size(); i += 4)
    ASSERT_NEAR(drawing.image.rgba[i], -std::expm1(-1.0), 1e-5) << "pixel " << i / 4;
  FaceOrder order;
  const PreparedScene& prepared = drawing.prepared;
  sortMethod("exact")
      .make({prepared.points, prepared.mesh.tetrahedra, &prepared.faces})
      ->sort(viewPoint(drawing.view), order);
  const ReplayResult replayed = replay({prepared.points, &prepared.faces, order.faces, {}, drawing.view}, 14);
  // The replay's coverage is exact, the rasteriser's on its grid: they differ where an edge passes a pixel's centre.
  EXPECT_NEAR(static_cast<double>(drawing.certificate->fragments), static_cast<double>(replayed.fragments),
              0.002 * static_cast<double>(replayed.fragments));
}

// Lists beyond what the shader sorts in local memory (256).
TEST_P(ABuffer, SortsLongLists) {
  constexpr int kLayers = 400;
  const TetMesh slab = gridMesh(1, 1, kLayers, Cut::six, [](int i, int j, int k) {
    return Vec3(i - 0.5, j - 0.5, static_cast<double>(k) / kLayers);
  });
  const TransferFile transfer(constantTransfer(1.0));
  Scene scene = sceneBy("abuffer");
  scene.transferFunction = transfer.path();
  scene.lookup = "post";
  scene.width = scene.height = 48;
  scene.camera.azimuth = 10;
  const Drawing drawing = draw(*device_, scene, withPointField(slab, constantField(slab.points, 0.5)));
  EXPECT_GT(drawing.certificate->fragments, 256u * 48 * 48 / 10);  // so some pixels have far more than 256
  const Difference difference = againstOpacity(drawing, [&](int x, int y) {
    return -std::expm1(-lengthInBox(rayOf(drawing, x, y), {-0.5, -0.5, 0}, {0.5, 0.5, 1}));
  });
  // 1,200 segments composited in float, each of which rounds by 6e-8.
  EXPECT_LE(difference.maximum, 1200 * 6e-8) << difference;
}

HAVS_FOR_EVERY_DEVICE(VisibilityAgreement);
HAVS_FOR_EVERY_DEVICE(ABuffer);

class RealMesh : public testing::TestWithParam<const char*> {};

TEST_P(RealMesh, IsTheSameByEveryMethod) {
  const std::string file = std::string(HAVS_SHARED_DATA) + "/" + GetParam();
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const auto device = makeTestDevice("osmesa");
  Scene scene;
  scene.width = scene.height = 256;
  scene.transferFunction = "three-peaks";
  scene.tableSize = 64;
  scene.certificate = true;
  const TetMesh mesh = readMesh(file);
  const Drawing expected = draw(*device, scene, mesh);
  for (const char* method : {"abuffer", "cells"}) {
    scene.visibility = method;
    const Drawing drawing = draw(*device, scene, mesh);
    EXPECT_LE(quantileBetween(drawing.image, expected.image, maskOf(drawing), 0.999), 2e-5) << method;
    ASSERT_TRUE(drawing.certificate);
    // Non-convex: from some directions a few cells of the topological order lie behind another part, or grazing ones
    // cross.
    EXPECT_LE(drawing.certificate->misordered, 20u) << method << " of " << drawing.certificate->fragments;
  }
}

INSTANTIATE_TEST_SUITE_P(Files, RealMesh, testing::Values("spx.inp", "bluntfinxyz.bin"),
                         [](const auto& file) { return std::string(file.param).substr(0, 3); });

}  // namespace
}  // namespace havs::test
