// The native device's picture does not depend on how it was drawn: threads, tiles, lanes and the speculative first
// pass leave every bit as it is. Each pixel's arithmetic is the same numbers in the same order.
#include "core/parallel.h"
#include "image/native_scene.h"
#include "render/lookups.h"
#include "render/native/instruction_sets.h"
#include "support/lookup_names.h"
#include "support/meshes.h"
#include "support/temporary_folder.h"

namespace havs::test {
namespace {

struct Case {
  std::string name;
  TetMesh (*make)();
};
inline void PrintTo(const Case& c, std::ostream* stream) { *stream << c.name; }

std::vector<Case> cases() {
  return {{"JitteredBox", [] { return withSmoothPoints(box(6, Cut::six, 0.25, 3)); }},
          {"CellData", [] { return withSmoothCells(box(5, Cut::five, 0.2, 5)); }},
          {"NestedShells", [] { return withSmoothPoints(nestedShells(4)); }},
          {"StretchedLayers", [] { return withSmoothPoints(stretchedLayers(8, 1.8)); }},
          {"VisibilityCycle", [] { return withSmoothPoints(visibilityCycle()); }},
          {"FewLargeCells", [] { return withSmoothPoints(box(1)); }}};
}

/// Several tiles of every side, and a rest that is no whole stamp.
Scene pictureOf(const std::string& lookup = "exact") {
  Scene scene;
  scene.width = 203;
  scene.height = 150;
  scene.lookup = lookup;
  scene.transferFunction = "three-peaks";
  return scene;
}

/// The settings that a picture may not depend on.
void expectSameForAllWays(const NativeScene& scene) {
  const havs::Drawing expected = scene.draw();
  for (const int side : {4, 16, 32, 128, 256})
    EXPECT_EQ(
        differenceInBits(scene.draw([&](RenderPlan& plan) { plan.tileWidth = plan.tileHeight = side; }), expected), "")
        << "tiles of " << side;
  for (const std::size_t threads : {1u, 2u, 3u}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(differenceInBits(scene.draw(), expected), "") << threads << " threads";
  }
  for (const InstructionSet& set : instructionSets()) {
    if (!set.available()) continue;
    EXPECT_EQ(differenceInBits(scene.draw([&](RenderPlan& plan) { plan.instructionSet = set.name; }), expected), "")
        << set.name;
  }
  EXPECT_EQ(differenceInBits(scene.draw([](RenderPlan& plan) { plan.speculate = false; }), expected), "")
      << "without the speculative pass";
}

class NativeBits : public testing::TestWithParam<Case> {};

TEST_P(NativeBits, Topological) { expectSameForAllWays({pictureOf(), GetParam().make()}); }

TEST_P(NativeBits, Orthographic) {
  Scene scene = pictureOf();
  scene.camera.projection = Projection::orthographic;
  expectSameForAllWays({scene, GetParam().make()});
}

/// Many fragments come late, so that many pixels are drawn a second time.
TEST_P(NativeBits, WrongOrderWithCertificate) {
  Scene scene = pictureOf();
  scene.certificate = true;
  for (const char* sort : {"centroid", "none"}) {
    SCOPED_TRACE(sort);
    scene.sort = sort;
    expectSameForAllWays({scene, GetParam().make()});
  }
}

TEST_P(NativeBits, EarlyTermination) {
  Scene scene = pictureOf();
  scene.transferFunction = "viridis";
  scene.earlyTermination = 0.4;
  for (const char* sort : {"topological", "none"})
    for (const bool certificate : {false, true}) {
      SCOPED_TRACE(std::string(sort) + (certificate ? " with certificate" : ""));
      scene.sort = sort;
      scene.certificate = certificate;
      expectSameForAllWays({scene, GetParam().make()});
    }
}

TEST_P(NativeBits, LateFragmentsComposited) {
  Scene scene = pictureOf();
  scene.sort = "none";
  scene.compositeLate = true;
  expectSameForAllWays({scene, GetParam().make()});
}

TEST_P(NativeBits, ClosePartlyBehindTheEye) {
  Scene scene = pictureOf();
  NativeScene drawn(scene, GetParam().make());
  const LocalFrame& frame = drawn.prepared.frame;
  // Above the mesh, where a corner of the bounding sphere is empty, looking along its top.
  drawn.scene.camera.eye = frame.center + frame.radius * Vec3{0.1, 0.85, 0.05};
  drawn.scene.camera.target = frame.center + frame.radius * Vec3{0.6, 0.2, 0.4};
  drawn.scene.camera.fieldOfView = 110;
  drawn.view = viewOf(drawn.scene, drawn.prepared);
  expectSameForAllWays(drawn);
}

INSTANTIATE_TEST_SUITE_P(Meshes, NativeBits, testing::ValuesIn(cases()),
                         [](const testing::TestParamInfo<Case>& row) { return row.param.name; });

class NativeBitsOfLookup : public testing::TestWithParam<std::string> {};

TEST_P(NativeBitsOfLookup, PointAndCellData) {
  Scene scene = pictureOf(GetParam());
  scene.tableSize = tableOf(lookup(GetParam())) ? std::optional(24) : std::nullopt;
  expectSameForAllWays({scene, withSmoothPoints(box(4, Cut::six, 0.2, 7))});
  expectSameForAllWays({scene, withSmoothCells(box(4, Cut::six, 0.2, 7))});
}

TEST_P(NativeBitsOfLookup, OpaqueSurfaces) {
  Scene scene = pictureOf(GetParam());
  scene.transferFunction = "plateau-opaque";
  scene.tableSize = tableOf(lookup(GetParam())) ? std::optional(24) : std::nullopt;
  expectSameForAllWays({scene, withSmoothPoints(ball(5))});
}

INSTANTIATE_TEST_SUITE_P(Lookups, NativeBitsOfLookup, testing::ValuesIn(lookupNames()),
                         [](const testing::TestParamInfo<std::string>& row) { return testName(row.param); });

}  // namespace
}  // namespace havs::test
