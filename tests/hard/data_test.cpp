// Scalars that are no numbers: they are holes, the same whatever they are, or refused.
#include "hard/data_scenes.h"

namespace havs::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kQuiet = std::numeric_limits<double>::quiet_NaN();
constexpr double kSignalling = std::numeric_limits<double>::signaling_NaN();

const std::vector<double>& notNumbers() {
  static const std::vector<double> values{kQuiet, -kQuiet, kSignalling, kInfinity, -kInfinity};
  return values;
}

TetMesh withCells(TetMesh mesh, std::vector<double> values) {
  mesh.cellFields = {Field{"c", 1, std::move(values)}};
  return mesh;
}

/// One value a cell: the smooth field at its centroid.
std::vector<double> smoothCells(const TetMesh& mesh) {
  std::vector<Vec3> centroids;
  for (const Tetrahedron& t : mesh.tetrahedra)
    centroids.push_back(0.25 * (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]] + mesh.points[t[3]]));
  return smoothField(centroids);
}

/// The smooth field, but `value` at the points that are `where`.
std::vector<double> replaced(const TetMesh& mesh, const std::function<bool(const Vec3&)>& where, double value) {
  auto values = smoothField(mesh.points);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (where(mesh.points[i])) values[i] = value;
  return values;
}

/// The mesh without some cells: what holes must look like.
TetMesh without(const TetMesh& mesh, const std::function<bool(std::size_t cell)>& gone) {
  TetMesh rest = mesh;
  rest.tetrahedra.clear();
  for (std::size_t c = 0; c < mesh.tetrahedra.size(); ++c)
    if (!gone(c)) rest.tetrahedra.push_back(mesh.tetrahedra[c]);
  return rest;
}

bool touches(const TetMesh& mesh, std::size_t cell, const std::function<bool(const Vec3&)>& where) {
  const Tetrahedron& t = mesh.tetrahedra[cell];
  return std::any_of(t.begin(), t.end(), [&](Index point) { return where(mesh.points[point]); });
}

class DataNoNumbers : public EveryModeTest {
 protected:
  using Make = std::function<TetMesh(double value)>;

  /// What `make` makes of NaN, in every way and mode; the same as `cutOut`, whose holes were cut beforehand; and bit by
  /// bit what it makes of other values that are no numbers.
  void expectHoles(const Scene& scene, const Make& make, const TetMesh& cutOut, std::optional<double> surface) {
    const HardPicture picture = expectEveryWay(scene, make(kQuiet));
    EXPECT_GT(picture.prepared.notes.size(), 0u) << "holes are told of";
    // Both are exact but for the order in which cells are numbered.
    expectSame("truth against that of the mesh without those cells", picture.truth, HardPicture(scene, cutOut).truth,
               1e-6);
    for (const double value : notNumbers()) {
      const HardPicture other(scene, make(value));
      expectSame("NaN of either kind and sign, either infinity", other.truth, picture.truth, 0);
      const HardWay native = hardWays().front();
      expectSame("the same, native", drawIn(native, scene, other.prepared, other.view).image,
                 picture.by(native.name).image, 0);
    }
    expectEveryMode(scene, make(kQuiet), surface);
  }
};

TEST_F(DataNoNumbers, AtOnePoint) {
  tell({"Data",
        "one scalar that is NaN or infinite spoils every pixel of its cells, and as an end of the range all others",
        "ranges are of finite values; cells that touch it are holes, whose faces are boundary"});
  const TetMesh plain = box(kCells);
  const auto middle = [](const Vec3& p) { return p == Vec3{0}; };
  const auto make = [&](double value) { return withPoints(plain, replaced(plain, middle, value)); };
  expectHoles(sceneOver({}), make, without(make(0), [&](std::size_t c) { return touches(plain, c, middle); }), 0.5);
}

TEST_F(DataNoNumbers, InARegionOfPoints) {
  tell({"Data", "solvers mark what they did not compute by NaN or infinity: a whole region is no number",
        "the region is left out with every cell that touches it; the rest keeps its range"});
  const TetMesh plain = box(kCells, Cut::five);
  const auto region = [](const Vec3& p) { return p.x > 0.2 && p.y > -0.3; };
  const auto make = [&](double value) { return withPoints(plain, replaced(plain, region, value)); };
  expectHoles(sceneOver({}), make, without(make(0), [&](std::size_t c) { return touches(plain, c, region); }), 0.5);
}

TEST_F(DataNoNumbers, InCells) {
  tell({"Data", "values of cells that are no numbers, one alone and a region of them",
        "those cells alone are holes; their neighbours show as they are"});
  const TetMesh plain = box(kCells);
  const auto smooth = smoothCells(plain);
  const auto gone = [&](std::size_t c) {
    return c == 11 || touches(plain, c, [](const Vec3& p) { return p.x < -0.6; });
  };
  const auto make = [&](double value) {
    auto values = smooth;
    for (std::size_t c = 0; c < values.size(); ++c)
      if (gone(c)) values[c] = value;
    return withCells(plain, values);
  };
  std::vector<double> left;
  for (std::size_t c = 0; c < smooth.size(); ++c)
    if (!gone(c)) left.push_back(smooth[c]);
  expectHoles(sceneOver({}), make, withCells(without(plain, gone), left), {});
}

TEST_F(DataNoNumbers, Everywhere) {
  tell({"Data", "a field without a finite value has no range, and every pixel would be no number",
        "refused, for points and for cells, naming the field"});
  const TetMesh plain = box(2);
  for (const double value : notNumbers()) {
    expectRefused(sceneOver({}), withPoints(plain, constantField(plain.points, value)), "no finite value");
    expectRefused(sceneOver({}), withCells(plain, std::vector<double>(plain.tetrahedra.size(), value)),
                  "no finite value");
  }
}

TEST_F(DataNoNumbers, InEveryCellSomewhere) {
  tell({"Data", "there are finite values, but no cell has finite ones only: nothing is left to draw",
        "refused, saying that the field is finite in no cell"});
  const TetMesh plain = box(2);
  auto values = constantField(plain.points, kQuiet);
  values[0] = 0.5;
  expectRefused(sceneOver({}), withPoints(plain, values), "finite in no cell");
}

using DataVectors = EveryModeTest;

TetMesh withVectors(TetMesh mesh, const std::function<std::array<double, 3>(const Vec3&)>& vector) {
  Field field{"v", 3, {}};
  for (const Vec3& p : mesh.points)
    for (const double component : vector(p)) field.values.push_back(component);
  mesh.pointFields = {std::move(field)};
  return mesh;
}

TEST_F(DataVectors, MagnitudeOfComponentsThatAreNoNumbers) {
  tell({"Data",
        "the length of a vector with one NaN, or with infinity and NaN, is NaN in one library and infinity in another",
        "either is not finite: a hole; other vectors, and other components of this one, are not touched"});
  const TetMesh plain = box(kCells);
  const auto middle = [](const Vec3& p) { return p == Vec3{0}; };
  const auto smooth = [](const Vec3& p) { return std::array{1 + p.x, 0.5 * p.y, 0.25 + p.z}; };
  std::optional<Image> first;
  for (const auto& bad : {std::array{kQuiet, 0.0, 1.0}, {1.0, kInfinity, kQuiet}, {-kInfinity, 0.0, kInfinity}}) {
    const TetMesh mesh = withVectors(plain, [&](const Vec3& p) { return middle(p) ? bad : smooth(p); });
    const HardPicture picture = expectEveryWay(sceneOver({}), mesh);
    if (first) expectSame("pictures of different numbers that are none", picture.truth, *first, 0);
    first = picture.truth;
  }
  Scene scene = sceneOver({});
  scene.field = "v:x";
  const TetMesh inY = withVectors(plain, [&](const Vec3& p) {
    auto v = smooth(p);
    if (middle(p)) v[1] = kQuiet;
    return v;
  });
  const HardPicture component(scene, inY), whole(scene, withVectors(plain, smooth));
  expectSame("a component beside one that is no number", component.truth, whole.truth, 0);
}

TEST_F(DataVectors, MagnitudeBeyondTheLargestDouble) {
  tell(
      {"Data", "components of 1.5e308 are finite, the vector's length is not: squares overflow from 1e154 on",
       "lengths are taken without squares, so that only those beyond 1.8e308 are infinite; they are holes, and noted"});
  const TetMesh plain = box(kCells);
  const TetMesh mesh = withVectors(plain, [](const Vec3& p) {
    const double big = p == Vec3{0} ? 1.5e308 : 1e300 * (2 + p.x);
    return std::array{big, big, big};
  });
  const HardPicture picture = expectEveryWay(sceneOver({}), mesh);
  EXPECT_LE(picture.prepared.field.maximum, 6e300);
  const TetMesh plainer = withVectors(plain, [](const Vec3& p) {
    const double size = p == Vec3{0} ? kInfinity : 2 + p.x;
    return std::array{size, size, size};
  });
  // Powers of ten are no powers of two: scalars differ in their last digits.
  expectSame("against the same of order 1", picture.truth, HardPicture(sceneOver({}), plainer).truth, 1e-6);
}

TEST_F(DataVectors, AnotherFieldIsNoNumber) {
  tell({"Data", "a field that is not drawn is NaN throughout", "only the field that is drawn makes holes"});
  const TetMesh plain = withPoints(box(kCells), smoothField(box(kCells).points));
  TetMesh mesh = plain;
  mesh.pointFields.push_back({"other", 1, constantField(mesh.points, kQuiet)});
  mesh.cellFields.push_back({"cells", 1, std::vector<double>(mesh.tetrahedra.size(), kInfinity)});
  const HardPicture picture = expectEveryWay(sceneOver({}), mesh);
  expectSame("against the mesh without it", picture.truth, HardPicture(sceneOver({}), plain).truth, 0);
}

}  // namespace
}  // namespace havs::test
