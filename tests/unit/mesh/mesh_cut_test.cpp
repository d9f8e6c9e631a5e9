// Meshes cut at planes: what is kept and what goes make up the whole, fit together, and keep what the field says.
#include "mesh/mesh_cut.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "mesh/defects.h"
#include "mesh/half_space.h"
#include "mesh/read.h"
#include "support/meshes.h"
#include "unit/mesh/mesh_checks.h"

namespace havs {
namespace {

TetMesh applied(const MeshCut& cut, const TetMesh& mesh) {
  TetMesh part;
  part.points = cut.pointValues(mesh.points);
  part.tetrahedra = cut.tetrahedra;
  return part;
}

TetMesh inside(const TetMesh& mesh, const HalfSpace& half) {
  return applied(partInside(mesh.tetrahedra, mesh.points, half), mesh);
}

HalfSpace opposite(const HalfSpace& half) { return {-half.normal, -half.offset}; }

/// Every cell split, nothing left out.
MeshCut splitAt(const TetMesh& mesh, const HalfSpace& half) {
  return cutMesh(mesh.tetrahedra, levelsOf(mesh.points, half),
                 std::vector<CellFate>(mesh.tetrahedra.size(), CellFate::split));
}

std::vector<TetMesh> meshes() {
  return {
      test::box(5, test::Cut::six, 0.25, 4), test::box(4, test::Cut::five), test::ball(5),       test::nestedShells(1),
      test::stretchedLayers(6, 0.5),         test::singleTetrahedron(),     test::boxWithHole(6)};
}

std::vector<HalfSpace> halfSpaces() {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<HalfSpace> halves{{{1, 0, 0}, 0.0}, {{0, 1, 0}, 0.1}, {{0, 0, -1}, -0.2}};
  for (int i = 0; i < 12; ++i)
    halves.push_back({normalize(Vec3{unit(random), unit(random), unit(random)}), 0.4 * unit(random)});
  halves.push_back({normalize(Vec3{1, 1, 1}), 0.0});  // through many points of the grids
  return halves;
}

// Volumes of up to some thousand pieces, summed up to 8 at most: each sum rounds by 2^-53 of it.
constexpr double kRounding = 5e-12;

TEST(MeshCut, HalvesMakeUpTheWhole) {
  for (const TetMesh& mesh : meshes())
    for (const HalfSpace& half : halfSpaces()) {
      const TetMesh above = inside(mesh, half), below = inside(mesh, opposite(half));
      EXPECT_NEAR(test::totalVolume(above) + test::totalVolume(below), test::totalVolume(mesh), kRounding);
      const MeshCut split = splitAt(mesh, half);
      EXPECT_NEAR(test::totalVolume(applied(split, mesh)), test::totalVolume(mesh), kRounding);
      EXPECT_EQ(above.tetrahedra.size() + below.tetrahedra.size(), split.tetrahedra.size());
    }
}

TEST(MeshCut, OfABoxHasTheVolumeOfTheClosedForm) {
  const TetMesh box = test::box(5, test::Cut::six, 0.25, 4);
  EXPECT_NEAR(test::totalVolume(inside(box, {{1, 0, 0}, 0.3})), 4 * 0.7, kRounding);
  // The corner beyond x + y + z = 2 of [-1, 1]^3: a tetrahedron with edges of 1 along the axes.
  EXPECT_NEAR(test::totalVolume(inside(box, {normalize(Vec3{1, 1, 1}), 2 / std::sqrt(3.0)})), 1.0 / 6, kRounding);
}

// Planes that come near to points leave thin pieces; none is flat, none turned over, none there twice.
TEST(MeshCut, LeavesNoFlatCellAndNoDuplicate) {
  for (const TetMesh& mesh : meshes()) {
    std::vector<HalfSpace> halves = halfSpaces();
    for (const double shift : {1e-6, 1.1e-8, 0.9e-8, 1e-12, 1e-16})
      halves.push_back({{1, 0, 0}, mesh.points[mesh.points.size() / 2].x + shift});
    for (const HalfSpace& half : halves) {
      const TetMesh part = inside(mesh, half);
      std::set<Tetrahedron> seen;
      for (Tetrahedron t : part.tetrahedra) {
        ASSERT_GT(test::volumeOf(part, t), 0);
        std::sort(t.begin(), t.end());
        ASSERT_TRUE(seen.insert(t).second);
      }
    }
  }
}

using Places = std::array<std::array<double, 3>, 3>;

/// The faces that only one cell has, as places, sorted within each.
std::multiset<Places> boundaryOf(const TetMesh& mesh) {
  std::multiset<Places> faces;
  for (const auto& [face, count] : test::faceCounts(mesh)) {
    EXPECT_LE(count, 2);
    if (count != 1) continue;
    Places places;
    for (std::size_t i = 0; i < 3; ++i)
      for (int axis = 0; axis < 3; ++axis) places[i][static_cast<std::size_t>(axis)] = mesh.points[face[i]][axis];
    std::sort(places.begin(), places.end());
    faces.insert(places);
  }
  return faces;
}

Vec3 pointOf(const std::array<double, 3>& place) { return {place[0], place[1], place[2]}; }

double areaOf(const Places& face) {
  const Vec3 a = pointOf(face[0]);
  return 0.5 * length(cross(pointOf(face[1]) - a, pointOf(face[2]) - a));
}

template <class Distance>
bool isAll(const Places& face, const Distance& distance) {
  return std::all_of(face.begin(), face.end(),
                     [&](const auto& place) { return std::abs(distance(pointOf(place))) <= 1e-15; });
}

bool isOnBox(const Places& face) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double end : {-1.0, 1.0})
      if (isAll(face, [&](const Vec3& p) { return p[axis] - end; })) return true;
  return false;
}

// Inner faces are shared by two cells: each face that only one cell has lies on the box or on the plane, where both
// halves have the same faces, to the last bit.
TEST(MeshCut, ConformsAndItsSectionIsPlanar) {
  const TetMesh box = test::box(5, test::Cut::six, 0.25, 4);
  for (const HalfSpace& half : halfSpaces()) {
    std::array<std::set<Places>, 2> sections;
    double area = 0, onBox = 0;
    for (const std::size_t side : {0u, 1u})
      for (const Places& face : boundaryOf(inside(box, side == 0 ? half : opposite(half)))) {
        if (isAll(face, [&](const Vec3& p) { return half.level(p); })) {
          sections[side].insert(face);
          area += areaOf(face);
        } else {
          ASSERT_TRUE(isOnBox(face));
          onBox += areaOf(face);
        }
      }
    EXPECT_EQ(sections[0], sections[1]);
    EXPECT_NEAR(onBox, 24, kRounding);
    const bool axisAligned = std::abs(half.normal.x) + std::abs(half.normal.y) + std::abs(half.normal.z) == 1;
    if (axisAligned) {
      EXPECT_NEAR(area, 8, kRounding) << "4 on each side";
    }
  }
}

// Only some cells are split: their neighbours follow where they share an edge, and no other.
TEST(MeshCut, ConformsWhereOnlySomeCellsAreSplit) {
  const TetMesh box = test::box(5, test::Cut::six, 0.25, 4);
  const std::multiset<Places> before = boundaryOf(box);
  for (const HalfSpace& half : halfSpaces()) {
    std::vector<CellFate> fates(box.tetrahedra.size(), CellFate::stays);
    for (std::size_t c = 0; c < fates.size(); c += 7) fates[c] = CellFate::split;
    const MeshCut cut = cutMesh(box.tetrahedra, levelsOf(box.points, half), fates);
    const TetMesh part = applied(cut, box);
    for (const Places& face : boundaryOf(part)) ASSERT_TRUE(isOnBox(face));
    EXPECT_NEAR(test::totalVolume(part), 8, kRounding);
    for (std::size_t c = 0; c < cut.cells.size(); ++c) {
      if (fates[cut.cells[c]] == CellFate::split) {
        EXPECT_NE(cut.pieceSide[c], 0);
      }
    }
  }
}

TEST(MeshCut, KeepsALinearFieldExactAndCopiesTheCells) {
  const auto linear = [](const Vec3& p) { return 0.3 + 2 * p.x - p.y + 0.5 * p.z; };
  for (const TetMesh& mesh : meshes())
    for (const HalfSpace& half : halfSpaces()) {
      const MeshCut cut = partInside(mesh.tetrahedra, mesh.points, half);
      const std::vector<Vec3> points = cut.pointValues(mesh.points);
      const std::vector<double> values = cut.pointValues(test::pointValues(mesh.points, linear));
      for (std::size_t i = 0; i < points.size(); ++i) ASSERT_NEAR(values[i], linear(points[i]), 1e-14);
      std::vector<double> numbers(mesh.tetrahedra.size());
      for (std::size_t c = 0; c < numbers.size(); ++c) numbers[c] = static_cast<double>(c);
      const std::vector<double> sources = cut.cellValues(numbers);
      ASSERT_EQ(sources.size(), cut.tetrahedra.size());
      EXPECT_TRUE(std::is_sorted(sources.begin(), sources.end()));
    }
}

// As at a seam, where two layers of points lie at the same places under different numbers: a cut point's place does not
// depend on which end of the edge is the lower number.
TEST(MeshCut, PlacesDoNotDependOnNumbers) {
  const TetMesh mesh = test::box(3, test::Cut::six, 0.25, 8);
  TetMesh reversed = mesh;
  const auto last = static_cast<Index>(mesh.points.size() - 1);
  std::reverse(reversed.points.begin(), reversed.points.end());
  for (Tetrahedron& t : reversed.tetrahedra)
    for (Index& p : t) p = last - p;
  const auto places = [](const TetMesh& part) {
    std::multiset<std::array<double, 3>> all;
    for (const Vec3& p : part.points) all.insert({p.x, p.y, p.z});
    return all;
  };
  for (const HalfSpace& half : halfSpaces()) EXPECT_EQ(places(inside(mesh, half)), places(inside(reversed, half)));
}

TEST(MeshCut, IsTheSameForAnyNumberOfThreads) {
  const TetMesh mesh = test::box(14, test::Cut::six, 0.25, 8);
  const HalfSpace half{normalize(Vec3{1, 2, 3}), 0.1};
  const MeshCut many = partInside(mesh.tetrahedra, mesh.points, half);
  const ThreadLimit limit(1);
  const MeshCut one = partInside(mesh.tetrahedra, mesh.points, half);
  EXPECT_EQ(many.tetrahedra, one.tetrahedra);
  EXPECT_EQ(many.cells, one.cells);
  EXPECT_EQ(many.keptPoints, one.keptPoints);
  EXPECT_EQ(many.pointValues(mesh.points), one.pointValues(mesh.points));
}

TEST(MeshCut, BesideTheMeshKeepsAllOrNothing) {
  const TetMesh mesh = test::box(3);
  const MeshCut all = partInside(mesh.tetrahedra, mesh.points, {{1, 0, 0}, -1.0});
  EXPECT_EQ(all.tetrahedra, mesh.tetrahedra);
  EXPECT_EQ(all.pointValues(mesh.points), mesh.points);
  const MeshCut nothing = partInside(mesh.tetrahedra, mesh.points, {{1, 0, 0}, 1.0});
  EXPECT_TRUE(nothing.tetrahedra.empty());
  EXPECT_EQ(nothing.pointCount(), 0u);
}

// Cells of aspect ratios up to thousands: volumes add up, and no piece is turned over.
TEST(MeshCut, OfBluntFinHasTheVolumeOfTheWhole) {
  const auto file = std::filesystem::path(HAVS_SHARED_DATA) / "bluntfinxyz.bin";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "there is no " << file;
  TetMesh mesh = repairMesh(readMesh(file));  // it has flat cells
  const Vec3 first = mesh.points.front();
  for (Vec3& p : mesh.points) p = (p - first) / 10.0;  // nearly the local frame
  const double whole = test::totalVolume(mesh), least = test::smallestVolume(mesh);
  ASSERT_GT(least, 0);
  for (const HalfSpace& direction : halfSpaces()) {
    const HalfSpace half{direction.normal, dot(direction.normal, mesh.points[mesh.points.size() / 2])};
    const TetMesh above = inside(mesh, half), below = inside(mesh, opposite(half));
    EXPECT_NEAR(test::totalVolume(above) + test::totalVolume(below), whole, 1e-12 * whole);
    EXPECT_GT(std::min(test::smallestVolume(above), test::smallestVolume(below)), 0);
  }
}

}  // namespace
}  // namespace havs
