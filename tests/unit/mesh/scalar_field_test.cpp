#include "mesh/scalar_field.h"

#include <gmock/gmock.h>

#include <limits>

#include "unit/mesh/mesh_checks.h"

namespace havs {
namespace {
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// Two tetrahedra on five points, and a sixth point that no cell uses.
TetMesh twoCells() {
  TetMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {9, 9, 9}};
  mesh.tetrahedra = {{0, 1, 2, 3}, {1, 2, 3, 4}};
  mesh.pointFields = {{"velocity", 3, {3, 4, 0, 0, 0, 2, 1, 2, 2, 0, 0, 0, -6, 0, 8, 100, 0, 0}},
                      {"density", 1, {1, 2, 3, 4, 5, 600}},
                      {"a:b", 1, {7, 7, 7, 7, 7, 7}}};
  mesh.cellFields = {{"density", 1, {10, 20}}, {"stress", 2, {1, 2, 3, 4}}};
  return mesh;
}

std::string selectError(const TetMesh& mesh, const std::string& name) {
  return test::inputError([&] { selectField(mesh, name); });
}

TEST(MagnitudeAt, IsTheLengthAtAnyScale) {
  for (const double scale : {1.0, 1e-300, 1e300}) {
    const Field field{"v", 3, {0, 0, 0, 2 * scale, -3 * scale, 6 * scale}};
    EXPECT_EQ(magnitudeAt(field, 0), 0);
    EXPECT_NEAR(magnitudeAt(field, 1), 7 * scale, 1e-15 * 7 * scale);
  }
  EXPECT_EQ(magnitudeAt({"s", 1, {-4}}, 0), 4);
}

TEST(SelectField, DefaultIsTheFirstPointScalarThenVectorThenCellScalar) {
  TetMesh mesh = twoCells();
  ScalarField field = selectField(mesh, "");
  EXPECT_EQ(field.name, "density");
  EXPECT_EQ(field.centering, Centering::point);
  EXPECT_EQ(field.minimum, 1);
  EXPECT_EQ(field.maximum, 5);  // not of the point that no cell uses

  mesh.pointFields.resize(1);
  field = selectField(mesh, "");
  EXPECT_EQ(field.name, "velocity:magnitude");
  EXPECT_THAT(field.values, ElementsAre(5, 2, 3, 0, 10, 100));

  mesh.pointFields.clear();
  field = selectField(mesh, "");
  EXPECT_EQ(field.centering, Centering::cell);
  EXPECT_THAT(field.values, ElementsAre(10, 20));

  mesh.cellFields.clear();
  EXPECT_THAT(selectError(mesh, ""), HasSubstr("no field to draw"));
}

TEST(SelectField, ComponentsMagnitudeAndCentering) {
  const TetMesh mesh = twoCells();
  EXPECT_THAT(selectField(mesh, "velocity:x").values, ElementsAre(3, 0, 1, 0, -6, 100));
  EXPECT_THAT(selectField(mesh, "velocity:2").values, ElementsAre(0, 2, 2, 0, 8, 0));
  EXPECT_THAT(selectField(mesh, "point:velocity:y").values, ElementsAre(4, 0, 2, 0, 0, 0));
  EXPECT_EQ(selectField(mesh, "velocity").name, "velocity:magnitude");
  EXPECT_THAT(selectField(mesh, "velocity:magnitude").values, ElementsAre(5, 2, 3, 0, 10, 100));
  EXPECT_THAT(selectField(mesh, "density:magnitude").values, ElementsAre(1, 2, 3, 4, 5, 600));
  EXPECT_EQ(selectField(mesh, "density").centering, Centering::point);
  EXPECT_THAT(selectField(mesh, "cell:density").values, ElementsAre(10, 20));
  EXPECT_THAT(selectField(mesh, "stress:1").values, ElementsAre(2, 4));
  EXPECT_EQ(selectField(mesh, "stress:1").centering, Centering::cell);
  EXPECT_EQ(selectField(mesh, "a:b").minimum, 7);
  EXPECT_EQ(selectField(mesh, "point:a:b").minimum, 7);
}

TEST(SelectField, WhatIsNotThereIsNamedWithTheNearest) {
  const TetMesh mesh = twoCells();
  EXPECT_THAT(selectError(mesh, "densty"),
              AllOf(HasSubstr("no field 'densty'"), HasSubstr("did you mean 'density'"), HasSubstr("velocity"),
                    HasSubstr("cell:density"), HasSubstr("stress")));
  EXPECT_THAT(selectError(mesh, "cell:velocity"), HasSubstr("no field 'cell:velocity'"));
  EXPECT_THAT(selectError(mesh, "velocity:3"), AllOf(HasSubstr("no component '3'"), HasSubstr("it has 3")));
  EXPECT_THAT(selectError(mesh, "velocity:w"), HasSubstr("no component 'w'"));
  EXPECT_THAT(selectError(mesh, "stress:z"), HasSubstr("no component 'z'"));
  EXPECT_THAT(selectError(mesh, "velocity:-1"), HasSubstr("no component '-1'"));
  EXPECT_THAT(selectError(mesh, "velocity:"), HasSubstr("no component ''"));
}

TEST(SelectField, RangeIsOfFiniteValuesAndThereMustBeOne) {
  TetMesh mesh = twoCells();
  mesh.pointFields[1].values = {kNoValue, 2, std::numeric_limits<double>::infinity(), 4, 3, 600};
  const ScalarField field = selectField(mesh, "density");
  EXPECT_EQ(field.minimum, 2);
  EXPECT_EQ(field.maximum, 4);
  mesh.pointFields[1].values = {kNoValue, kNoValue, kNoValue, kNoValue, kNoValue, 600};  // finite only where no cell is
  EXPECT_THAT(selectError(mesh, "density"), HasSubstr("'density' has no finite value"));
}

TEST(SelectField, MagnitudeNeitherOverflowsNorVanishes) {
  TetMesh mesh = twoCells();
  mesh.pointFields = {{"v", 2, {3e300, 4e300, 3e-300, 4e-300, 0, 0, 0, 0, 0, 0, 0, 0}}};
  const ScalarField field = selectField(mesh, "v");
  EXPECT_DOUBLE_EQ(field.values[0], 5e300);
  EXPECT_DOUBLE_EQ(field.values[1], 5e-300);
}

TEST(FieldFromExpression, IsEvaluatedAtEveryPoint) {
  TetMesh mesh = twoCells();
  for (int i = 0; i < 100000; ++i) mesh.points.emplace_back(i, -i, 0.5 * i);  // several blocks of the parallel loop
  const Field field = fieldFromExpression(mesh, "f", "sqrt(x^2 + y^2) + pi*z");
  EXPECT_EQ(field.name, "f");
  ASSERT_EQ(field.values.size(), mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vec3 p = mesh.points[i];
    EXPECT_DOUBLE_EQ(field.values[i], std::sqrt(p.x * p.x + p.y * p.y) + 3.141592653589793 * p.z);
  }
}

TEST(FieldFromExpression, MistakesAreShownWithTheirPosition) {
  const TetMesh mesh = twoCells();
  const auto error = [&](const std::string& expression) {
    return test::inputError([&] { fieldFromExpression(mesh, "f", expression); });
  };
  EXPECT_THAT(error("x + w"), AllOf(HasSubstr("x + w"), HasSubstr("\"w\""), HasSubstr("position 4")));
  EXPECT_THAT(error("sqrt(x"), HasSubstr("position"));
  EXPECT_THAT(error(""), HasSubstr("expression ''"));
}

TEST(WithoutHoles, CellsAtAPointThatIsNotFiniteGo) {
  TetMesh mesh = twoCells();
  mesh.pointFields[1].values[4] = kNoValue;
  ScalarField field = selectField(mesh, "density");
  EXPECT_EQ(withoutHoles(mesh, field), 1u);
  EXPECT_THAT(mesh.tetrahedra, ElementsAre(Tetrahedron{0, 1, 2, 3}));
  EXPECT_THAT(mesh.cellFields[0].values, ElementsAre(10));
  EXPECT_THAT(mesh.cellFields[1].values, ElementsAre(1, 2));
  EXPECT_EQ(withoutHoles(mesh, field), 0u);
}

TEST(WithoutHoles, CellsWhoseOwnValueIsNotFiniteGo) {
  TetMesh mesh = twoCells();
  mesh.cellFields[0].values[0] = -std::numeric_limits<double>::infinity();
  ScalarField field = selectField(mesh, "cell:density");
  EXPECT_EQ(withoutHoles(mesh, field), 1u);
  EXPECT_THAT(mesh.tetrahedra, ElementsAre(Tetrahedron{1, 2, 3, 4}));
  EXPECT_THAT(field.values, ElementsAre(20));
  EXPECT_EQ(field.minimum, 20);
}

TEST(WithoutHoles, MeshOfHolesIsRefused) {
  TetMesh mesh = twoCells();
  mesh.pointFields[1].values[2] = kNoValue;  // a point of both cells
  ScalarField field = selectField(mesh, "density");
  EXPECT_THAT(test::inputError([&] { withoutHoles(mesh, field); }), HasSubstr("finite in no cell"));
}

}  // namespace
}  // namespace havs
