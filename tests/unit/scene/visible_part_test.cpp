// What a transfer function shows, and the part of a mesh that shows anything, each against its definition.
#include "scene/visible_part.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "scene/shown_scalars.h"
#include "scene/visible_part_renderer.h"
#include "support/meshes.h"

namespace havs {
namespace {

ExtinctionCurve curveOf(const std::vector<std::array<double, 2>>& scalarAndKappa) {
  ExtinctionCurve curve;
  for (const auto& [s, kappa] : scalarAndKappa) curve.knots.push_back({s, {1, 1, 1}, kappa});
  return curve;
}

/// Extinction is linear between knots and never negative: it is above 0 somewhere on a range if it is at an end or at a
/// knot inside. Both knots of a step count.
bool showsByDefinition(const ExtinctionCurve& curve, double low, double high) {
  if (curve.at(low).kappa > 0 || curve.at(high).kappa > 0) return true;
  return std::any_of(curve.knots.begin(), curve.knots.end(),
                     [&](const auto& k) { return k.s >= low && k.s <= high && k.kappa > 0; });
}

TEST(ShownScalars, RangesThatOnlyTouchWhereExtinctionIsZeroAreNotShown) {
  const ShownScalars shows(
      curveOf({{0, 0}, {0.2, 0}, {0.3, 1}, {0.4, 0}, {0.6, 0}, {0.6, 2}, {0.7, 2}, {0.7, 0}, {1, 0}}));
  EXPECT_FALSE(shows.meet(0, 0.2));
  EXPECT_TRUE(shows.meet(0, 0.20001));
  EXPECT_FALSE(shows.meet(0.4, 0.5));
  EXPECT_TRUE(shows.meet(0.1, 0.9));
  EXPECT_TRUE(shows.meet(0.5, 0.6)) << "a step's upper side";
  EXPECT_TRUE(shows.meet(0.7, 0.8)) << "a step's lower side";
  EXPECT_FALSE(shows.meet(0.70001, 1));
  EXPECT_TRUE(ShownScalars(curveOf({{0, 0}, {1, 0}})).empty());
}

TEST(ShownScalars, AreThoseOfTheDefinition) {
  std::mt19937 random(7);
  std::size_t shown = 0, asked = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<std::array<double, 2>> knots;  // on a grid, so that ranges end at knots and steps occur
    for (int i = 0; i <= 16; ++i)
      for (unsigned n = 1 + random() % 2; n > 0; --n) knots.push_back({i / 16.0, random() % 6 == 0 ? 0.5 : 0.0});
    const ExtinctionCurve curve = curveOf(knots);
    const ShownScalars shows(curve);
    for (int i = 0; i < 100; ++i) {
      double low = static_cast<double>(random() % 33) / 32, high = static_cast<double>(random() % 33) / 32;
      if (low > high) std::swap(low, high);
      const bool expected = showsByDefinition(curve, low, high);
      ASSERT_EQ(shows.meet(low, high), expected) << low << " to " << high << " in round " << round;
      shown += expected ? 1 : 0;
      ++asked;
    }
  }
  EXPECT_GT(shown, asked / 10);
  EXPECT_LT(shown, asked - asked / 10);
}

TEST(ShownScalars, HaveTheOpaqueSurfacesOfEveryPreset) {
  for (const TransferPreset& preset : transferPresets()) {
    const ExtinctionCurve curve = makeCurve(preset.function, {});
    const ShownScalars shows(curve);
    for (const auto& [low, high] : curve.opaque) {
      EXPECT_TRUE(shows.meet(low, low)) << preset.name;
      EXPECT_TRUE(shows.meet(high, high)) << preset.name;
    }
  }
}

PreparedScene prepared(TetMesh mesh, const std::string& transferFunction, bool cellData = false) {
  std::vector<double> values = test::smoothField(mesh.points);
  if (cellData) {
    values.resize(mesh.tetrahedra.size());
    for (std::size_t c = 0; c < values.size(); ++c) values[c] = static_cast<double>(c % 97) / 96;
    mesh.cellFields = {Field{"s", 1, std::move(values)}};
  } else {
    mesh.pointFields = {Field{"s", 1, std::move(values)}};
  }
  Scene scene;
  scene.transferFunction = transferFunction;
  StageTimes stages;
  return prepareScene(scene, std::move(mesh), stages);
}

using Corners = std::array<std::array<double, 3>, 3>;  // of a face, the least first, in its sense

/// A face as places: sense kept, first corner chosen.
Corners placed(const PreparedScene& scene, std::size_t face) {
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& p = scene.points[scene.faces.vertices[face][i]];
    corners[i] = {p.x, p.y, p.z};
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

std::multiset<Corners> placedFaces(const PreparedScene& scene, bool boundary) {
  std::multiset<Corners> all;
  for (std::size_t f = 0; f < scene.faces.size(); ++f)
    if (scene.faces.isBoundary(f) == boundary) all.insert(placed(scene, f));
  return all;
}

class VisiblePart : public testing::TestWithParam<std::tuple<std::string, bool>> {};

TEST_P(VisiblePart, IsTheMeshOfTheCellsThatShowAnything) {
  const auto& [transferFunction, cellData] = GetParam();
  const PreparedScene whole = prepared(test::nestedShells(6), transferFunction, cellData);
  const std::vector<unsigned char> shown = shownCells(whole);
  const auto part = visiblePart(whole);
  ASSERT_TRUE(part);

  // Every cell by the definition, in the old order, with the same places and scalars.
  std::size_t next = 0;
  for (std::size_t c = 0; c < shown.size(); ++c) {
    const Tetrahedron& cell = whole.mesh.tetrahedra[c];
    double low = whole.scalars[cellData ? c : cell[0]], high = low;
    if (!cellData)
      for (const Index p : cell) low = std::min(low, whole.scalars[p]), high = std::max(high, whole.scalars[p]);
    ASSERT_EQ(shown[c] != 0, showsByDefinition(whole.curve, low, high)) << c;
    if (shown[c] == 0) continue;
    ASSERT_LT(next, part->mesh.tetrahedra.size());
    const Tetrahedron& drawn = part->mesh.tetrahedra[next];
    for (std::size_t i = 0; i < 4; ++i) {
      ASSERT_EQ(part->points[drawn[i]], whole.points[cell[i]]);
      ASSERT_EQ(part->mesh.points[drawn[i]], whole.mesh.points[cell[i]]);
      if (!cellData) {
        ASSERT_EQ(part->scalars[drawn[i]], whole.scalars[cell[i]]);
      }
    }
    if (cellData) {
      ASSERT_EQ(part->scalars[next], whole.scalars[c]);
    }
    ++next;
  }
  EXPECT_EQ(next, part->mesh.tetrahedra.size());
  EXPECT_GT(next, 0u);

  // Faces as if they had been built of these cells alone.
  PreparedScene built;
  built.points = part->points;
  built.faces = buildFaces(part->mesh);
  EXPECT_EQ(part->faces.boundaryCount, built.faces.boundaryCount);
  EXPECT_EQ(placedFaces(*part, true), placedFaces(built, true)) << "boundary, normals out of the mesh";
  EXPECT_EQ(part->faces.size(), built.faces.size());
  for (std::size_t c = 0; c < next; ++c)
    for (std::size_t i = 0; i < 4; ++i) {
      const Index face = part->faces.ofCell[c][i];
      const auto& sides = part->faces.cells[face];
      ASSERT_TRUE(sides[0] == c || sides[1] == c);
      const auto& corners = part->faces.vertices[face];
      const Vec3 normal = cross(part->points[corners[1]] - part->points[corners[0]],
                                part->points[corners[2]] - part->points[corners[0]]);
      const double outwards = dot(normal, part->points[corners[0]] - part->points[part->mesh.tetrahedra[c][i]]);
      ASSERT_EQ(outwards > 0, sides[0] == c) << "the normal points out of the first cell";
    }
  ASSERT_EQ(part->facesInWhole.size(), part->faces.size());
  EXPECT_TRUE(std::is_sorted(part->facesInWhole.begin(), part->facesInWhole.end()));
  for (std::size_t f = 0; f < part->faces.size(); ++f) {
    auto sorted = [](Corners corners) {
      std::sort(corners.begin(), corners.end());
      return corners;
    };
    ASSERT_EQ(sorted(placed(*part, f)), sorted(placed(whole, part->facesInWhole[f])));
  }
}

TEST_P(VisiblePart, KeepsWhatDescribesTheWhole) {
  const auto& [transferFunction, cellData] = GetParam();
  const PreparedScene whole = prepared(test::nestedShells(6), transferFunction, cellData);
  const PreparedScene part = *visiblePart(whole);
  EXPECT_EQ(part.whole, &whole);
  EXPECT_EQ(part.longestEdge, whole.longestEdge);
  EXPECT_EQ(part.frame.radius, whole.frame.radius);
  EXPECT_EQ(part.frame.center, whole.frame.center);
  EXPECT_EQ(part.curve.maximumKappa, whole.curve.maximumKappa);
  EXPECT_EQ(part.curve.unitLength, whole.curve.unitLength);
  EXPECT_EQ(part.facts().cellData, cellData);
  EXPECT_EQ(part.facts().opaqueSurfaces, whole.facts().opaqueSurfaces);
  EXPECT_EQ(part.field.minimum, whole.field.minimum);
}

INSTANTIATE_TEST_SUITE_P(Presets, VisiblePart,
                         testing::Combine(testing::Values("three-peaks", "shells", "plateau-opaque"), testing::Bool()));

TEST(VisiblePart, IsNothingToDoWhereAllCellsShow) { EXPECT_FALSE(visiblePart(prepared(test::box(3), "viridis"))); }

TEST(VisiblePart, OfAClearTransferFunctionIsEmptyAndItsPictureToo) {
  PreparedScene whole = prepared(test::box(3), "viridis");
  for (auto& knot : whole.curve.knots) knot.kappa = 0;
  const PreparedScene part = *visiblePart(whole);
  EXPECT_TRUE(part.mesh.tetrahedra.empty());
  EXPECT_TRUE(part.points.empty());
  EXPECT_EQ(part.faces.size(), 0u);

  StageTimes stages;
  for (const bool certificate : {false, true}) {
    const auto renderer =
        rendererOfVisiblePart(whole, {}, certificate, stages, [](const PreparedScene&) -> std::unique_ptr<Renderer> {
          ADD_FAILURE() << "there is nothing to draw";
          return nullptr;
        });
    View view;
    view.width = 3;
    view.height = 2;
    const Drawing drawing = renderer->draw(view, stages);
    EXPECT_EQ(drawing.image.rgba, std::vector<float>(24, 0.0f));
    EXPECT_EQ(drawing.drawnCells, 0u);
    ASSERT_EQ(drawing.certificate.has_value(), certificate);
    if (certificate) {
      EXPECT_EQ(drawing.certificate->count, std::vector<std::uint32_t>(6, 0));
    }
  }
}

}  // namespace
}  // namespace havs
