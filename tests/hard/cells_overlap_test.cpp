// Cells that lie over each other. The truth gives each place of a ray to one cell, that entered first; buffers of
// fragments cannot. What is promised: pictures are finite, the length of a ray inside the mesh is right, pixels whose
// rays meet no overlap are right, and overlaps are counted.
#include "hard/cell_checks.h"
#include "hard/hard_meshes.h"

namespace havs::test {
namespace {

class CellOverlaps : public CellsTest {
 protected:
  void tellOverlap(const std::string& what) {
    tellCells(
        what + ": here not counted before, so that a picture with mixed scalars looked like any other",
        "counted as overlapping_cells by planes between cells, and noted; each place of a ray counts once, as the "
        "inside-count only asks whether it is inside");
  }

  void expectOverlap(const TetMesh& mesh, std::size_t cells) {
    const HardPicture picture = expectRightBesideOverlaps(mesh);
    expectDefects(picture.prepared, "overlapping_cells", cells);
    TetMesh even = mesh;
    even.pointFields = {Field{"s", 1, constantField(mesh.points, 0.4)}};
    SCOPED_TRACE("one scalar");
    // Drawn one after the other, parts may be late: counted.
    expectCells(even, {.late = ~std::size_t{0}});
  }
};

TetMesh cellFromTo(const Vec3& low, double edge) {
  TetMesh mesh = singleTetrahedron();
  for (Vec3& p : mesh.points) p = low + edge * p;
  return mesh;
}

TEST_F(CellOverlaps, TwoCellsPartly) {
  tellOverlap("two cells that lie partly over each other");
  expectOverlap(merged(merged(cellFromTo(Vec3(0.0), 1), cellFromTo(Vec3(0.3, 0.1, 0.1), 0.8)),
                       boxFromTo(Vec3(-2, -1, -1), Vec3(-0.5, 1, 1), 2)),
                2);
}

TEST_F(CellOverlaps, OneCellInsideAnother) {
  tellOverlap("a cell inside another one, no face of which it meets");
  expectOverlap(merged(merged(cellFromTo(Vec3(0.0), 1), cellFromTo(Vec3(0.15), 0.2)),
                       boxFromTo(Vec3(-2, -1, -1), Vec3(-0.5, 1, 1), 2)),
                2);
}

TEST_F(CellOverlaps, AFaceOfThreeCells) {
  tellOverlap("a triangle that is a face of three cells, two of them on one side");
  TetMesh mesh = boxFromTo(Vec3(-2, -1, -1), Vec3(-0.5, 1, 1), 2);
  const auto first = static_cast<Index>(mesh.points.size());
  mesh.points.insert(mesh.points.end(),
                     {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 0.7}, {0.5, 0.3, 0.4}, {0.3, 0.3, -0.6}});
  mesh.tetrahedra.insert(mesh.tetrahedra.end(), {{first, first + 1, first + 2, first + 3},
                                                 {first, first + 1, first + 2, first + 4},
                                                 {first, first + 2, first + 1, first + 5}});
  expectOverlap(mesh, 2);
  StageTimes stages;
  expectDefects(prepareScene(rampScene(), withPointData(mesh), stages), "overfull_faces", 1);
}

TEST_F(CellOverlaps, TwoCellsOnOneSideOfAFace) {
  tellOverlap("two cells on the same side of a common triangle, which is no more than two cells' face");
  TetMesh mesh = boxFromTo(Vec3(-2, -1, -1), Vec3(-0.5, 1, 1), 2);
  const auto first = static_cast<Index>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 0.7}, {0.5, 0.3, 0.4}});
  mesh.tetrahedra.insert(mesh.tetrahedra.end(),
                         {{first, first + 1, first + 2, first + 3}, {first, first + 1, first + 2, first + 4}});
  expectOverlap(mesh, 2);
}

TEST_F(CellOverlaps, APointPulledThroughItsNeighbours) {
  tellOverlap("a point moved through a face, as mesh motion does it: cells turn over into their neighbours");
  TetMesh mesh = box(4, Cut::six);
  for (Vec3& p : mesh.points)
    if (length(p) < 1e-12) p = Vec3(0.7, 0.1, 0.2);
  const HardPicture picture = expectRightBesideOverlaps(mesh);
  const std::size_t inverted = defectCount(picture.prepared, "inverted_cells");
  expectAtMost("inverted cells not found", inverted > 0 ? 0 : 1, 0);
  expectAtMost("overlapping cells not found", defectCount(picture.prepared, "overlapping_cells") > inverted ? 0 : 1, 0);
}

TEST_F(CellOverlaps, NoneWhereCellsOnlyTouch) {
  tellCells("cells that touch at points, along edges, on faces that do not fit, or within rounding, taken for overlaps",
            "a plane parts them; what it may cut off is 1e-6 of the radius deep");
  const std::pair<const char*, TetMesh> meshes[] = {
      {"boxes on each other", twoBoxes(2, 0)},
      {"boxes a rounding into each other", twoBoxes(2, -1e-12)},
      {"faces that do not fit",
       merged(boxFromTo(Vec3(-1, -1, -1), Vec3(0, 1, 1), 1), boxFromTo(Vec3(0, -1, -1), Vec3(1.0), 3))},
      {"slivers", sliverLayer(4, 1e-9)},
      {"around a point", cellsAroundPoint(2)},
      {"around an edge", cellsAroundEdge(100)},
      {"a seam", oGrid(3, 12, 3)},
      {"edges from 1e-6", gradedGrid(6, 1e-6)},
      {"layers", boundaryLayers(6, 1e4)},
      {"a ring", ringOfBricks(7)}};
  for (const auto& [name, mesh] : meshes) {
    SCOPED_TRACE(name);
    StageTimes stages;
    const PreparedScene prepared = prepareScene(rampScene(), withPointData(mesh), stages);
    expectAtMost("overlaps told", static_cast<double>(defectCount(prepared, "overlapping_cells")), 0);
  }
}

}  // namespace
}  // namespace havs::test
