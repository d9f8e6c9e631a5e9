// Isosurfaces made ready, what is refused, and the cells that they keep.
#include "scene/isosurface.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "core/error.h"
#include "scene/prepared_scene.h"
#include "scene/visible_part.h"
#include "support/meshes.h"

namespace havs {
namespace {

using testing::HasSubstr;

/// A box with x as its field, -1 to 1; or the cells' numbers.
TetMesh boxAlongX(bool cellData = false) {
  TetMesh mesh = test::box(6, test::Cut::six, 0.2);
  if (cellData) {
    std::vector<double> numbers(mesh.tetrahedra.size());
    for (std::size_t c = 0; c < numbers.size(); ++c) numbers[c] = static_cast<double>(c);
    mesh.cellFields = {Field{"number", 1, numbers}};
  } else {
    mesh.pointFields = {Field{"x", 1, test::pointValues(mesh.points, [](const Vec3& p) { return p.x; })}};
  }
  return mesh;
}

PreparedScene prepared(const Scene& scene, bool cellData = false) {
  StageTimes stages;
  return prepareScene(scene, boxAlongX(cellData), stages);
}

void expectRefused(const Scene& scene, const std::string& why, bool cellData = false) {
  try {
    static_cast<void>(prepared(scene, cellData));
    ADD_FAILURE() << "not refused: " << why;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_THAT(error.what(), HasSubstr(why));
    EXPECT_THAT(error.what(), HasSubstr("--isosurface"));
  }
}

TEST(Isosurfaces, AreSortedNormalisedAndHaveColours) {
  Scene scene;
  scene.isosurfaces = {{0.5, Color{1, 0, 0}, 0.25}, {-0.5, {}, 1}, {0.5, Color{0, 1, 0}, 1}};
  const PreparedScene made = prepared(scene);
  ASSERT_EQ(made.isosurfaces.size(), 3u);
  EXPECT_EQ(made.isosurfaces[0].scalar, 0.25);
  EXPECT_EQ(made.isosurfaces[0].value, -0.5);
  EXPECT_EQ(made.isosurfaces[0].color, made.curve.at(0.25).color);
  EXPECT_EQ(made.isosurfaces[0].opacity, 1);
  EXPECT_EQ(made.isosurfaces[1].color, (Color{1, 0, 0})) << "of one value, in the scene's order";
  EXPECT_EQ(made.isosurfaces[1].opacity, 0.25);
  EXPECT_EQ(made.isosurfaces[2].color, (Color{0, 1, 0}));
  EXPECT_TRUE(made.notes.empty());
}

TEST(Isosurfaces, WhatHasNoneIsRefused) {
  Scene scene;
  scene.isosurfaces = {{0.5, {}, 1}};
  expectRefused(scene, "belongs to the cells", true);
  scene.isosurfaces = {{1.001, {}, 1}};
  expectRefused(scene, "-1 to 1");
  scene.isosurfaces = {{-1.001, {}, 1}};
  expectRefused(scene, "-1 to 1");
  scene.isosurfaces = {{-1, {}, 1}};
  EXPECT_NO_THROW(prepared(scene)) << "the least value: nothing crosses it, but it is one";
}

TEST(Isosurfaces, AtTheEndsOfADomainThatCutsTheDataOff) {
  Scene scene;
  scene.domain = {-0.5, 0.75};
  scene.isosurfaces = {{-0.5, {}, 1}};
  expectRefused(scene, "-0.5 to 0.75");
  scene.isosurfaces = {{0.75, {}, 1}};
  const PreparedScene made = prepared(scene);
  EXPECT_EQ(made.isosurfaces[0].scalar, 1);
  EXPECT_THAT(made.notes, testing::Contains(HasSubstr("beyond the domain")));
}

/// Whether a surface lies within the margin of the cell's scalars.
bool crosses(const PreparedScene& scene, const Tetrahedron& cell) {
  const auto& s = scene.scalars;
  const auto [low, high] = std::minmax({s[cell[0]], s[cell[1]], s[cell[2]], s[cell[3]]});
  return std::any_of(scene.isosurfaces.begin(), scene.isosurfaces.end(), [l = low, h = high](const auto& surface) {
    return l <= surface.scalar + ShownScalars::kSurfaceMargin && h >= surface.scalar - ShownScalars::kSurfaceMargin;
  });
}

TEST(Isosurfaces, AloneKeepTheCellsThatTheyCross) {
  Scene scene;
  scene.isosurfaces = {{-0.7, {}, 1}, {0.123, {}, 0.5}, {0.124, {}, 0.5}};
  const PreparedScene whole = prepared(scene);
  EXPECT_TRUE(whole.facts().cellsWithoutSurface);
  const auto shown = shownCells(whole, {.volume = false});
  std::size_t kept = 0;
  for (std::size_t c = 0; c < shown.size(); ++c) {
    ASSERT_EQ(shown[c] == 1, crosses(whole, whole.mesh.tetrahedra[c])) << c;
    kept += shown[c];
  }
  EXPECT_GT(kept, 0u);
  EXPECT_LT(kept, shown.size() / 2);
  const auto part = visiblePart(whole, {.volume = false});
  ASSERT_TRUE(part);
  EXPECT_EQ(part->mesh.tetrahedra.size(), kept);
  EXPECT_EQ(part->isosurfaces.size(), 3u);
}

TEST(Isosurfaces, WithTheVolumeKeepTheCellsOfEither) {
  Scene scene;
  scene.transferFunction = "three-peaks";
  const PreparedScene volume = prepared(scene);
  const auto ofVolume = shownCells(volume);
  for (const double value : {-0.95, -0.3, 0.02, 0.4}) {
    scene.isosurfaces = {{value, {}, 1}};
    const PreparedScene both = prepared(scene);
    const auto ofBoth = shownCells(both);
    for (std::size_t c = 0; c < ofBoth.size(); ++c)
      ASSERT_EQ(ofBoth[c] == 1, ofVolume[c] == 1 || crosses(both, both.mesh.tetrahedra[c])) << value << ", cell " << c;
    EXPECT_EQ(shownCells(both, {.isosurfaces = false}), ofVolume);
  }
}

}  // namespace
}  // namespace havs
