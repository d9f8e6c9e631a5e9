// Points that coincide, that no cell uses, that are no places.
#include <cmath>
#include <limits>

#include "hard/cell_checks.h"
#include "hard/hard_meshes.h"

namespace havs::test {
namespace {

using CellPoints = CellsTest;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Two boxes that meet at x = 1, where each has its own points, `gap` apart.
TetMesh seam(double gap) {
  TetMesh mesh = twoBoxes(2, gap);
  for (Vec3& p : mesh.points) p.x += 1;
  return mesh;
}

/// 0.2 on one side of the seam, 0.9 on the other: points at the seam have two values.
TetMesh withJump(TetMesh mesh) {
  Field field{"s", 1, {}};
  for (std::size_t p = 0; p < mesh.points.size(); ++p) field.values.push_back(2 * p < mesh.points.size() ? 0.2 : 0.9);
  mesh.pointFields = {std::move(field)};
  return mesh;
}

TEST_F(CellPoints, CoincidentWithTheSameData) {
  tellCells("points that are there twice cut a mesh in two: boundaries inside, of which either may come first",
            "bit-identical points with the same data are welded on reading, and noted");
  TetMesh mesh = withPointData(seam(0));
  const HardPicture apart = expectCells(mesh);
  expectAtMost("points of the seam not welded", 25.0 - static_cast<double>(weldPoints(mesh)), 0);
  expectSame("the truths", expectCells(mesh).truth, apart.truth, 1e-6);
}

TEST_F(CellPoints, CoincidentWithOtherData) {
  tellCells(
      "at a seam where the field jumps points must stay two: exit and entry lie at one distance, and a swap gave "
      "the next segment the scalar of nothing (here up to 0.28 of a channel with cell data)",
      "not welded; an exit goes before the entry that it touches");
  expectCells(withJump(seam(0)));
  expectCells(withCellData(seam(0)), cellDataBounds());
}

TEST_F(CellPoints, OneUlpApart) {
  tellCells("points a rounding apart are not bit-identical: a gap, or an overlap, of 2e-16",
            "boundaries are joined by the inside-count, whatever lies between");
  for (const double gap : {0x1p-52, -0x1p-52}) {
    SCOPED_TRACE(gap);
    expectCells(withJump(seam(gap)));
    expectCells(withCellData(seam(gap)), cellDataBounds());
  }
}

TEST_F(CellPoints, Distance1e12Apart) {
  tellCells("a gap or an overlap of 1e-12, as other programs' rounding leaves it",
            "boundaries are joined by the inside-count, whatever lies between; no overlap is reported below 1e-6");
  for (const double gap : {1e-12, -1e-12}) {
    SCOPED_TRACE(gap);
    expectCells(withJump(seam(gap)));
    const HardPicture picture = expectCells(withCellData(seam(gap)), cellDataBounds());
    expectAtMost("overlaps told", static_cast<double>(defectCount(picture.prepared, "overlapping_cells")), 0);
  }
}

TEST_F(CellPoints, UnusedPointsAt1e30) {
  tellCells("points that no cell uses, far away: a bounding box of all points makes the mesh a speck",
            "frame and camera are fitted to the points that cells use; the others are left out and counted");
  TetMesh mesh = withPointData(box(3));
  const HardPicture expected = expectCells(mesh);
  for (const Vec3 far : {Vec3(1e30, 0, 0), Vec3(-1e30, 1e30, 1e300)}) {
    mesh.points.push_back(far);
    mesh.pointFields[0].values.push_back(1e9);
  }
  const HardPicture picture = expectCells(mesh);
  expectDefects(picture.prepared, "unreferenced_points", 2);
  expectSamePictures(picture, expected, 0);
}

TEST_F(CellPoints, UnusedPointsThatAreNoNumbers) {
  tellCells("a NaN in a point that no cell uses spreads through sums and boxes",
            "left out before anything is computed, and counted");
  TetMesh mesh = withPointData(box(3));
  const HardPicture expected = expectCells(mesh);
  mesh.points.insert(mesh.points.begin(), Vec3(kNan, 0, 0));
  mesh.pointFields[0].values.insert(mesh.pointFields[0].values.begin(), kNan);
  for (Tetrahedron& cell : mesh.tetrahedra)
    for (Index& v : cell) ++v;
  const HardPicture picture = expectCells(mesh);
  expectDefects(picture.prepared, "unreferenced_points", 1);
  expectDefects(picture.prepared, "non_finite_points", 1);
  expectSamePictures(picture, expected, 0);
}

TEST_F(CellPoints, UsedPointsThatAreNoNumbers) {
  tellCells("a cell with a NaN or an infinite corner has no place",
            "such cells are left out, and counted: a hole. The picture is that of the mesh without them");
  TetMesh mesh = withPointData(box(4));
  TetMesh without = mesh;
  const Index lost = 62;  // an inner point, and one at the surface
  const auto isLost = [](Index v) { return v == lost || v == 3; };
  std::erase_if(without.tetrahedra,
                [&](const Tetrahedron& cell) { return std::any_of(cell.begin(), cell.end(), isLost); });
  mesh.points[lost] = Vec3(0, kNan, 0);
  mesh.points[3].x = std::numeric_limits<double>::infinity();
  const HardPicture expected = expectCells(without), picture = expectCells(mesh);
  expectDefects(picture.prepared, "non_finite_points", 2);
  expectSamePictures(picture, expected, 0);
}

TEST_F(CellPoints, NoCellWithPlaces) {
  tellCells("every cell has a corner that is no number", "refused, with the number of cells and what to look at");
  TetMesh mesh = withPointData(cellsAroundPoint(0));
  mesh.points.back() = Vec3(kNan);
  expectRefused(rampScene(), mesh, "encloses a volume");
}

}  // namespace
}  // namespace havs::test
