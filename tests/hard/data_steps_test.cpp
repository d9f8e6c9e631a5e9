// Functions in the data's unit, labels at the steps of a function, outliers.
#include "hard/data_scenes.h"

namespace havs::test {
namespace {

using DataInItsUnit = DataTest;

TEST_F(DataInItsUnit, FieldOfOneValueInItsOwnUnit) {
  tell({"Data", "a transfer function in the data's unit over a field of one value: nothing lies between its points",
        "the function is taken at that value, also where it is denormal or near the largest double"});
  for (const double value : {2.5, 1e-320, -kLargest}) {
    expectConstant(sceneInDataUnit({{value, 0.7, 0.3, 0.2, 0.8}}), constantBox(value), {value, 0.7, 0.3, 0.2, 0.8},
                   value);
  }
}

TEST_F(DataInItsUnit, TransferFunctionWiderThanTheLargestDouble) {
  tell({"Data",
        "here the points of a function in the data's unit became NaN between -1.8e308 and 1.8e308, and scalars with it",
        "shares of an interval halve its ends where its width is no double"});
  const double unit = std::ldexp(1.0, 1014);
  const auto wide = [](double i) { return 2 * i - 1023; };
  const auto sceneAt = [](double scale) {
    return sceneInDataUnit({{-1023 * scale, 0.2, 0.4, 0.8, 0.5}, {1023 * scale, 0.9, 0.5, 0.1, 1}});
  };
  const auto meshAt = [&](double scale) { return steppedBox(1023, [=](double i) { return scale * wide(i); }); };
  const HardPicture steps(sceneAt(1), meshAt(1));
  expectSamePictures("against a width of 2046", expectEveryWay(sceneAt(unit), meshAt(unit)), steps);
  expectEveryMode(sceneAt(unit), meshAt(unit), unit);
  // The domain a part of it: ends are evaluated between the points.
  Scene part = sceneAt(unit), plain = sceneAt(1);
  part.domain = {{-300 * unit, 400 * unit}};
  plain.domain = {{-300.0, 400.0}};
  expectSamePictures("over a part of it", HardPicture(part, meshAt(unit)), HardPicture(plain, meshAt(1)));
}

TEST_F(DataInItsUnit, OneOutlier) {
  tell({"Data", "one scalar of 1e30 stretches the range: all others, of order 1, are one value of it",
        "drawn as the data say: the outlier's cells alone show a change, in double and in float alike"});
  const TetMesh plain = box(kCells);
  auto values = smoothField(plain.points);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (plain.points[i] == Vec3{0}) values[i] = 1e30;
  const TetMesh mesh = withPoints(plain, values);
  const HardPicture picture = expectEveryWay(sceneOver({}), mesh);
  for (double& value : values) value = value == 1e30 ? 1 : 0;
  expectSame("truth against 0 and 1", picture.truth, HardPicture(sceneOver({}), withPoints(plain, values)).truth, 1e-7);
  expectEveryMode(sceneOver({}), mesh, 1e29);
}

/// Two points of the middle cells at -outlier and outlier, the others in [0, 1].
TetMesh outlierBox(double below, double above) {
  const TetMesh mesh = box(kCells);
  auto values = smoothField(mesh.points);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (mesh.points[i] == Vec3{0}) values[i] = above;
    if (mesh.points[i] == Vec3{0.5, 0.5, 0.5} && below < 0) values[i] = below;
  }
  return withPoints(mesh, values);
}

TEST_F(DataInItsUnit, OutlierAboveAFunctionInTheDatasUnit) {
  tell({"Data", "an outlier of 1e30 leaves a function of 0 to 1 in the data's unit 1e-30 of the domain",
        "float is finest next to 0, and knots are kept to 48 bits: scalars and knots of 1e-30 are told apart as those "
        "of 1"});
  expectEveryWay(sceneInDataUnit(points()), outlierBox(0, 1e30));
  // In the middle of -1000 to 1000 float is 6e-5 apart in the data's unit: some 1e-4 of this function.
  expectEveryWay(sceneInDataUnit(points()), outlierBox(-1e3, 1e3), {.native = 2e-4, .p999 = 5e-4, .traced = 2e-3});
}

TEST_F(DataInItsUnit, OutliersOnBothSidesOfAFunctionInTheDatasUnit) {
  tell({"Data",
        "between outliers of both signs a function of 0 to 1 lies in the domain's middle, where float is 1e-7 apart: "
        "here pictures were 0.6 off for 1e9, and for 1e30 the reference's, too",
        "refused, where float does not tell a hundredth of the values apart as the function does; a narrower domain is "
        "drawn"});
  for (const double outlier : {1e9, 1e12, 1e30, 1e300, kLargest})
    expectRefused(sceneInDataUnit(points()), outlierBox(-outlier, outlier), "float does not tell");
  expectRefused(sceneInDataUnit(points()), outlierBox(0, 1e300), "float does not tell");
  Scene narrow = sceneInDataUnit(points());
  narrow.domain = {{0, 1}};
  expectSamePictures("over the function's own domain", expectEveryWay(narrow, outlierBox(-1e30, 1e30)),
                     HardPicture(sceneOver(std::array{0.0, 1.0}), outlierBox(-1e30, 1e30)));
}

TEST_F(DataInItsUnit, OneOutlierOutsideTheDomain) {
  tell({"Data",
        "the same outlier under a domain of the other scalars: its normalised scalar is 1e30, infinite in a product",
        "cut off at the domain's end before anything is float: the picture of a field that has the end's value there"});
  const TetMesh plain = box(kCells);
  const auto with = [&](double value) {
    auto values = smoothField(plain.points);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (plain.points[i] == Vec3{0}) values[i] = value;
    return withPoints(plain, values);
  };
  const Scene scene = sceneOver(std::array{0.0, 1.0});
  const HardPicture cut(scene, with(1));
  expectSamePictures("against the end's value", expectEveryWay(scene, with(1e30)), cut);
  expectSamePictures("of 1.8e308", HardPicture(scene, with(kLargest)), cut);
  expectEveryMode(scene, with(1e30), 0.7);
}

/// Colours and extinctions of labels 0 to `most`, each from its own value to the next: steps at the labels themselves.
Scene labelScene(int most, double shift) {
  std::vector<std::array<double, 5>> steps;
  for (int i = 0; i <= most; ++i) {
    const double color = static_cast<double>(i % 5) / 4, extinction = 0.3 + i % 3;
    if (i > 0) steps.push_back({i - shift, color, 1 - color, 0.5, extinction});
    if (i < most) steps.push_back({i + 1 - shift, color, 1 - color, 0.5, extinction});
  }
  return sceneInDataUnit(steps);
}

TEST_F(DataInItsUnit, LabelsUnderStepsBetweenThem) {
  tell({"Data", "whole numbers under a function that jumps midway between them, many times within a cell",
        "segments are cut at every step; each side keeps its colour"});
  const TetMesh mesh = steppedBox(10, [](double i) { return i; });
  expectEveryWay(labelScene(10, 0.5), mesh);
  expectEveryMode(labelScene(10, 0.5), mesh, 2);
}

TEST_F(DataInItsUnit, LabelsOfCellsUnderStepsAtThem) {
  tell({"Data",
        "the natural function of labels jumps at each label; here 0.7, rounded to float, lay below a step at 0.7, and "
        "the "
        "highest label below its own at 1: whole cells had the wrong colour, 0.6 off",
        "steps go 2^-21 lower than asked for, in the reference too: a label is on the upper side, whatever float makes "
        "of it"});
  TetMesh mesh = box(kCells, Cut::five, 0.2);
  Field field{"label", 1, {}};
  for (std::size_t c = 0; c < mesh.tetrahedra.size(); ++c) field.values.push_back(static_cast<double>(c * 7 % 11));
  mesh.cellFields = {field};
  const HardPicture picture = expectEveryWay(labelScene(10, 0), mesh);
  expectSame("truth against steps midway", picture.truth, HardPicture(labelScene(10, 0.5), mesh).truth, 1e-7);
  expectEveryMode(labelScene(10, 0), mesh, {});
}

TEST_F(DataInItsUnit, LabelsOfPointsUnderStepsAtThem) {
  tell({"Data",
        "blocks of one label at the points: OpenGL interpolates a constant to within a rounding, on either side of the "
        "step",
        "steps lie lower by several roundings, so that a block has one colour"});
  // Blocks of one label, between them cells that go from one to the next.
  TetMesh mesh = box(2 * kCells);
  mesh.pointFields = {Field{"label", 1, pointValues(mesh.points, [](const Vec3& p) {
                              return std::clamp(std::floor(5.5 + 5.5 * p.x), 0.0, 10.0);
                            })}};
  expectEveryWay(labelScene(10, 0), mesh);
  expectEveryMode(labelScene(10, 0), mesh, 2);
}

}  // namespace
}  // namespace havs::test
