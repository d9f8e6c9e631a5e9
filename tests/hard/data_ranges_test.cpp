// Scalars and domains at the ends of what a double holds, and fields that meet the domain nowhere or at its ends only.
#include <limits>

#include "hard/every_mode.h"
#include "support/meshes.h"
#include "unit/reference/rays.h"

namespace havs::test {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kLeast = std::numeric_limits<double>::denorm_min();
constexpr int kCells = 4;  ///< of the box along each axis

/// Three extinctions, none 0: what the field is at the ends of its domain shows.
const std::vector<std::array<double, 5>>& points() {
  static const std::vector<std::array<double, 5>> rows{
      {0, 0.2, 0.4, 0.8, 0.5}, {0.5, 0.9, 0.8, 0.2, 1.5}, {1, 0.9, 0.5, 0.1, 1}};
  return rows;
}

Scene sceneOver(std::optional<std::array<double, 2>> domain) {
  Scene scene = hardScene();
  scene.transferFunction = transferFile(transferOf(points(), "extinction", 1, domain));
  return scene;
}

TetMesh withPoints(TetMesh mesh, std::vector<double> values) {
  mesh.pointFields = {Field{"s", 1, std::move(values)}};
  return mesh;
}

TetMesh constantBox(double value) {
  const TetMesh mesh = box(kCells);
  return withPoints(mesh, constantField(mesh.points, value));
}

/// The smooth field in whole steps, 0 to `most`: scaled by a power of two, or shifted, it keeps every digit.
TetMesh steppedBox(double most, const std::function<double(double)>& valueOf) {
  const TetMesh mesh = box(kCells, Cut::five, 0.2);
  auto values = smoothField(mesh.points);
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double from = *low, range = *high - *low;
  for (double& value : values) value = valueOf(std::round(most * (value - from) / range));
  return withPoints(mesh, values);
}

class DataRanges : public EveryModeTest {
 protected:
  /// The picture is that of a body of one colour and extinction, in closed form, and every way and mode agrees.
  void expectConstant(const Scene& scene, const TetMesh& mesh, const std::array<double, 5>& point, double surface) {
    const HardPicture picture = expectEveryWay(scene, mesh);
    const double half = 1 / picture.prepared.frame.radius;
    double most = 0;
    for (int y = 0; y < picture.view.height; ++y)
      for (int x = 0; x < picture.view.width; ++x) {
        const double length = throughBox(rayOf(picture.view, x, y), Vec3(-half), Vec3(half)).length() / half;
        const double alpha = -std::expm1(-point[4] * length);
        for (std::size_t c = 0; c < 4; ++c) {
          const double expected = alpha * (c < 3 ? point[c + 1] : 1);
          const double got = double{picture.truth.pixel(x, y)[c]};
          most = std::max(most, std::abs(got - expected));
        }
      }
    expectAtMost("truth against closed form", most, 1e-7);  // it is rounded to float
    expectEveryMode(scene, mesh, surface);
  }

  /// The same picture to the last bit, by the reference and the native device.
  void expectSamePictures(const std::string& what, const HardPicture& a, const HardPicture& b) {
    expectSame(what + ", truth", a.truth, b.truth, 0);
    const HardWay native = hardWays().front();
    expectSame(what + ", native", drawIn(native, a.scene, a.prepared, a.view).image,
               drawIn(native, b.scene, b.prepared, b.view).image, 0);
  }
};

TEST_F(DataRanges, FieldOfOneValue) {
  tell({"Data", "a field of one value has a range of no width: (s - low) / (high - low) is 0 / 0",
        "a domain of one value lies in the transfer function's middle, whatever the value: 0, 1, -5, denormal or "
        "1e300"});
  expectConstant(sceneOver({}), constantBox(1), points()[1], 1);
  const HardPicture one(sceneOver({}), constantBox(1));
  for (const double value : {0.0, -0.0, -5.0, 1e-320, kLeast, 1e300, kLargest, -kLargest}) {
    expectSamePictures("other values", HardPicture(sceneOver({}), constantBox(value)), one);
    expectEveryMode(sceneOver({}), constantBox(value), value);
  }
}

TEST_F(DataRanges, FieldOfOneValueInItsOwnUnit) {
  tell({"Data", "a transfer function in the data's unit over a field of one value: nothing lies between its points",
        "the function is taken at that value, also where it is denormal or near the largest double"});
  for (const double value : {2.5, 1e-320, -kLargest}) {
    Scene scene = hardScene();
    std::string json = transferOf({{value, 0.7, 0.3, 0.2, 0.8}}, "extinction", 1, {});
    json.insert(1, R"("scale": "data", )");
    scene.transferFunction = transferFile(json);
    expectConstant(scene, constantBox(value), {value, 0.7, 0.3, 0.2, 0.8}, value);
  }
}

TEST_F(DataRanges, EqualToTheDomainsMinimum) {
  tell({"Data", "the paper's shaders mark what is outside by the least scalar: a body of just that scalar vanishes",
        "inside and outside are told apart by the faces; every scalar of [0, 1] shows, the least included"});
  expectConstant(sceneOver(std::array{3.0, 4.0}), constantBox(3), points()[0], 3);
}

TEST_F(DataRanges, EqualToTheDomainsMaximum) {
  tell({"Data",
        "at the upper end of the domain tables are read beyond their last entry, and 1 has no room beside a kind",
        "the upper end is a scalar like any other; boundary fragments hold 1 - 2^-24 for it"});
  expectConstant(sceneOver(std::array{2.0, 3.0}), constantBox(3), points()[2], 3);
}

TEST_F(DataRanges, WhollyBelowTheDomain) {
  tell({"Data", "a field below the domain normalises to negative scalars, before the first entry of a table",
        "cut off at the domain's end: it shows as the lowest point of the transfer function, as far off as -1.8e308"});
  for (const double value : {0.999, -1e300, -kLargest})
    expectConstant(sceneOver(std::array{1.0, 2.0}), constantBox(value), points()[0], 1.5);
}

TEST_F(DataRanges, WhollyAboveTheDomain) {
  tell({"Data", "a field above the domain normalises to scalars above 1, behind the last entry of a table",
        "cut off at the domain's end: it shows as the highest point of the transfer function"});
  for (const double value : {2.001, 1e300, kLargest})
    expectConstant(sceneOver(std::array{1.0, 2.0}), constantBox(value), points()[2], 1.5);
}

TEST_F(DataRanges, Denormals) {
  tell(
      {"Data",
       "float has no room for 1e-320 and processors may flush it to 0: a field of denormals would be of one value",
       "scalars are normalised in double before anything is float: digit by digit the picture of the same steps of 1"});
  const HardPicture steps(sceneOver({}), steppedBox(1000, [](double i) { return i; }));
  const TetMesh denormal = steppedBox(1000, [](double i) { return i * kLeast; });
  expectSamePictures("against steps of 1", expectEveryWay(sceneOver({}), denormal), steps);
  expectEveryMode(sceneOver({}), denormal, 300 * kLeast);
}

TEST_F(DataRanges, NeighbouringDoubles) {
  tell({"Data", "a range of two neighbouring doubles, 1 and 1 + 2^-52: in float all is one value",
        "normalised in double, where the difference is exact: the picture of 0 and 1"});
  const auto two = [](double low, double high) { return steppedBox(1, [=](double i) { return i == 0 ? low : high; }); };
  const double next = std::nextafter(1.0, 2.0);
  const HardPicture steps(sceneOver({}), two(0, 1));
  expectSamePictures("against 0 and 1", expectEveryWay(sceneOver({}), two(1, next)), steps);
  expectSamePictures("1.8e308 and its neighbour",
                     HardPicture(sceneOver({}), two(std::nextafter(kLargest, 0.0), kLargest)), steps);
  expectEveryMode(sceneOver({}), two(1, next), next);
}

TEST_F(DataRanges, RangeWiderThanTheLargestDouble) {
  tell({"Data", "from -1.8e308 to 1.8e308 the width overflows to infinity: every scalar is 0 or NaN",
        "ends and value are halved first: digit by digit the picture of the same field at a scale that does not"});
  const double unit = std::ldexp(1.0, 1014);  // 1023 of it are the largest power of two but for a digit
  const auto wide = [](double i) { return 2 * i - 1023; };
  const TetMesh widest = steppedBox(1023, [&](double i) { return unit * wide(i); });
  const HardPicture steps(sceneOver({}), steppedBox(1023, wide));
  expectSamePictures("against a width of 2046", expectEveryWay(sceneOver({}), widest), steps);
  expectEveryMode(sceneOver({}), widest, unit * wide(300));
}

TEST_F(DataRanges, TransferFunctionWiderThanTheLargestDouble) {
  tell({"Data",
        "here the points of a function in the data's unit became NaN between -1.8e308 and 1.8e308, and scalars with it",
        "shares of an interval halve its ends where its width is no double"});
  const double unit = std::ldexp(1.0, 1014);
  const auto wide = [](double i) { return 2 * i - 1023; };
  const auto sceneAt = [&](double scale) {
    Scene scene = hardScene();
    std::string json =
        transferOf({{-1023 * scale, 0.2, 0.4, 0.8, 0.5}, {1023 * scale, 0.9, 0.5, 0.1, 1}}, "extinction", 1, {});
    json.insert(1, R"("scale": "data", )");
    scene.transferFunction = transferFile(json);
    return scene;
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

TEST_F(DataRanges, OneOutlier) {
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

TEST_F(DataRanges, OneOutlierOutsideTheDomain) {
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
  Scene scene = hardScene();
  std::string json = transferOf(steps, "extinction", 1, {});
  json.insert(1, R"("scale": "data", )");
  scene.transferFunction = transferFile(json);
  return scene;
}

TEST_F(DataRanges, LabelsUnderStepsBetweenThem) {
  tell({"Data", "whole numbers under a function that jumps midway between them, many times within a cell",
        "segments are cut at every step; each side keeps its colour"});
  const TetMesh mesh = steppedBox(10, [](double i) { return i; });
  expectEveryWay(labelScene(10, 0.5), mesh);
  expectEveryMode(labelScene(10, 0.5), mesh, 2);
}

TEST_F(DataRanges, LabelsOfCellsUnderStepsAtThem) {
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

TEST_F(DataRanges, LabelsOfPointsUnderStepsAtThem) {
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

TEST_F(DataRanges, DomainOfOneValueByRequest) {
  tell({"Data",
        "a domain whose ends are equal, reversed, NaN or wider than a double: scalars would divide by 0 or infinity",
        "refused, saying which; only a field may be of one value"});
  for (const std::array<double, 2>& domain :
       {std::array{0.3, 0.3}, {1.0, 0.0}, {std::nan(""), 1.0}, {0.0, HUGE_VAL}, {-kLargest, kLargest}}) {
    Scene scene = sceneOver({});
    scene.domain = domain;
    expectRefused(scene, constantBox(0.5), "domain");
  }
  expectRefused(sceneOver(std::array{0.3, 0.3}), constantBox(0.5), "domain");
}

}  // namespace
}  // namespace havs::test
