// Too few entries beside everything else a segment can be: lookups, light, surfaces, cell data, formats.
#include "hard/narrow_ways.h"
#include "reference/edge_mask.h"
#include "render/lookups.h"
#include "support/lookup_names.h"
#include "support/meshes.h"

namespace havs::test {
namespace {

Scene effectScene() {
  Scene scene = hardScene(48);
  scene.sort = "none";
  scene.transferFunction =
      transferFile(transferOf({{0, 0.2, 0.4, 0.8, 0.5}, {0.5, 0.9, 0.8, 0.2, 2}, {1, 0.9, 0.5, 0.1, 1}}));
  return scene;
}

class SmallKEffects : public HardPictureTest {
 protected:
  /// Draws with few entries and no order: pictures, on both devices; pixels without late fragments as the same device
  /// draws them with many entries, in topological order.
  void expectAsWide(const Scene& scene, const TetMesh& mesh, int wideK, const std::vector<int>& ks = {1, 3}) {
    const HardPicture picture(scene, mesh);
    for (const HardWay& wideWay : narrowWays("topological", {wideK})) {
      const havs::Drawing wide = drawIn(wideWay, scene, picture.prepared, picture.view);
      expectPicture(scene, wide.image);
      EXPECT_EQ(latePixels(wide), 0u);
      for (const HardWay& way : narrowWays("none", ks)) {
        if (way.device != wideWay.device) continue;
        SCOPED_TRACE(scene.lookup + ", " + way.name);
        const havs::Drawing narrow = drawIn(way, scene, picture.prepared, picture.view);
        expectPicture(scene, narrow.image);
        EXPECT_GT(latePixels(narrow), 300u) << "little is late: this tries nothing";
        EXPECT_LT(latePixels(narrow), narrow.certificate->count.size() - 300);
        // The same segments but for fragments within the tolerance of each other, 1e-6.
        expectAtMost(way.group + " max, pixels not named", mostOff(narrow, wide.image), 1e-5);
      }
    }
  }

 private:
  void expectPicture(const Scene& scene, const Image& image) {
    if (scene.lookup != "integral") {
      EXPECT_EQ(notAPicture(image), "");
      return;
    }
    // Light min(D, 1) of a segment that shows 1 - exp(-D): most where the depth D is 1.
    const double brightest = 1 / -std::expm1(-1.0);
    double most = 0;
    for (std::size_t c = 0; c < image.rgba.size(); ++c) {
      EXPECT_TRUE(std::isfinite(image.rgba[c]) && image.rgba[c] >= 0);
      if (image.rgba[c | 3] > 0) most = std::max(most, double{image.rgba[c]} / double{image.rgba[c | 3]});
    }
    expectAtMost("integral, colour over opacity", most, brightest);
  }
};

TEST_F(SmallKEffects, EveryLookup) {
  tell({"k too small",
        "segments between fragments that are not neighbours are longer than any edge, and their scalars farther apart "
        "than in any cell",
        "tables are read within their ends, whatever the length; samples and integrals are of any length: colours stay "
        "in [0, 1]"});
  Scene scene = effectScene();
  scene.tableSize = 16;
  for (const std::string& name : lookupNames()) {
    scene.lookup = name;
    expectAsWide(scene, withSmoothPoints(box(3)), lookup(name).carries == Payload::scalar ? 14 : 7, {1});
  }
}

TEST_F(SmallKEffects, Light) {
  tell({"k too small", "a lit segment weighs the light at both its ends, which may lie in cells far apart",
        "light is linear along a segment of any length, at most what both ends have"});
  Scene scene = effectScene();
  scene.lighting = Lighting{};
  expectAsWide(scene, withSmoothPoints(box(3)), 7, {1, 2, 3});
}

TEST_F(SmallKEffects, Isosurfaces) {
  tell({"k too small",
        "a segment over several cells crosses a surface elsewhere, or twice in the truth and not at all here",
        "crossings are those of the segment that is drawn, each once; pixels that are not named have them all"});
  Scene scene = effectScene();
  scene.isosurfaces = {{0.35, Color{0.9, 0.1, 0.1}, 0.5}, {0.6, Color{0.1, 0.1, 0.9}, 1}};
  expectAsWide(scene, withSmoothPoints(box(3)), 14);
}

TEST_F(SmallKEffects, OpaqueSurfaces) {
  tell({"k too small", "a segment that ends at a surface of opacity 1 leaves nothing for what comes late",
        "it is opaque in its own place; late fragments are dropped before or behind it"});
  Scene scene = effectScene();
  scene.transferFunction = transferFile(
      transferOf({{0, 0.2, 0.4, 0.8, 0.2}, {0.6, 0.9, 0.8, 0.2, 0.3}, {0.7, 0.9, 0.5, 0.1, 1}, {1, 0.9, 0.5, 0.1, 1}},
                 "per_unit"));
  expectAsWide(scene, withSmoothPoints(box(3)), 14);
}

TEST_F(SmallKEffects, CellData) {
  tell(
      {"k too small",
       "with cell data a segment has its front's value throughout, and a fragment that is late leaves it the wrong one",
       "values are of cells that there are, so colours stay in [0, 1]; pixels that are not named have the right ones"});
  TetMesh mesh = box(3);
  Field field{"c", 1, {}};
  for (std::size_t c = 0; c < mesh.tetrahedra.size(); ++c) field.values.push_back(static_cast<double>(c % 7) / 6);
  mesh.cellFields = {field};
  expectAsWide(effectScene(), mesh, 14);
}

TEST_F(SmallKEffects, TargetsOfHalves) {
  tell({"k too small", "in targets of half floats distances are off by 5e-4: order and lengths are lost in rounding",
        "fragments count as late beyond that rounding; pictures stay in [0, 1], few entries or many"});
  Scene scene = effectScene();
  scene.targetFormat = "16f";
  const HardPicture picture(scene, withSmoothPoints(box(3)));
  for (const HardWay& way : narrowWays("none")) {
    if (way.device == kNativeDevice) continue;
    SCOPED_TRACE(way.name);
    const havs::Drawing drawing = drawIn(way, scene, picture.prepared, picture.view);
    EXPECT_EQ(notAPicture(drawing.image), "");
    EXPECT_GT(latePixels(drawing), 300u);
    // Opacities and distances are off by 2^-11 each, some ten segments to a ray (docs/04-accuracy.md measures 4e-3).
    expectAtMost("k-buffer max, pixels not named",
                 mostOff(drawing, picture.truth,
                         boundaryEdgeMask(picture.prepared.points, picture.prepared.faces, picture.view)),
                 1e-2);
  }
}

TEST_F(SmallKEffects, EarlyTermination) {
  tell({"k too small",
        "a pixel that ends early looks at no more fragments, so none of them is late, though its colour may be wrong",
        "its late fragments up to then are counted; a pixel that is not named is right to what light was left"});
  Scene scene = effectScene();
  scene.earlyTermination = 0.6;
  const HardPicture picture(scene, withSmoothPoints(box(3)));
  const auto mask = boundaryEdgeMask(picture.prepared.points, picture.prepared.faces, picture.view);
  for (const HardWay& way : narrowWays("none")) {
    SCOPED_TRACE(way.name);
    const havs::Drawing drawing = drawIn(way, scene, picture.prepared, picture.view);
    EXPECT_EQ(notAPicture(drawing.image), "");
    EXPECT_GT(latePixels(drawing), 300u);
    expectAtMost(way.group + " max, pixels not named", mostOff(drawing, picture.truth, mask), 0.4 + 1e-5);
  }
}

}  // namespace
}  // namespace havs::test
