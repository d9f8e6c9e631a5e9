// How cells hang together: many around one point or edge, parts, shells, gaps, tunnels, faces that do not fit.
#include "hard/cell_checks.h"
#include "hard/hard_meshes.h"
#include "render/devices.h"
#include "render/k_search.h"

namespace havs::test {
namespace {

using CellTopology = CellsTest;

TEST_F(CellTopology, APointOf1280Cells) {
  tellCells("a fixed number of cells around a point overflows, and all of them meet in one pixel",
            "nothing is kept by the point; what rounding might hide of an edge's side is summed exactly");
  expectBothData(cellsAroundPoint(3));
}

TEST_F(CellTopology, AnEdgeOf500Cells) {
  tellCells("500 cells around an edge, with angles of 0.7 degrees: rays near it pass hundreds of thin wedges",
            "no bound on cells around an edge; a pixel's fragments come in order, so k does not matter");
  expectBothData(cellsAroundEdge(500));
}

TEST_F(CellTopology, OneCell) {
  tellCells("no inner face, nothing to sort, every face a boundary", "no special case");
  expectBothData(singleTetrahedron());
}

TEST_F(CellTopology, AHundredSeparateCells) {
  tellCells("a search over neighbours finds none: no relation between any two cells",
            "parts start from their boundary faces, near ones first, and the k-buffer mends what that misses");
  expectBothData(separateCells(100, 3));
}

TEST_F(CellTopology, ShellsFiveDeep) {
  tellCells("rays enter and leave ten times; part by part, all of a shell is drawn before the next: more than k",
            "the inside-count keeps hollows empty whatever the order; fragments that come too late for k are counted, "
            "and a larger k takes them in");
  const TetMesh mesh = withPointData(shellsInShells(5));
  const HardPicture picture = expectCells(mesh, {.late = ~std::size_t{0}});
  expectCells(withCellData(mesh), cellDataBounds({.late = ~std::size_t{0}}));
  Scene scene = picture.scene;
  scene.device = "native";
  expectAtMost("k that draws them in order",
               searchK(scene, picture.prepared, picture.view, openRenderDevice(kNativeDevice).capabilities), 14);
}

TEST_F(CellTopology, ATunnelSeenThrough) {
  tellCells("rays go in and out along a tunnel, most of whose walls are seen nearly edge on",
            "entries and exits follow the same exact coverage, so they balance in every pixel");
  Scene scene = rampScene();
  scene.camera.azimuth = 4;
  scene.camera.elevation = 3;
  expectBothData(boxWithHole(3), {}, scene);
}

TEST_F(CellTopology, HangingNodes) {
  tellCells("one large face against many small ones: matched by their points, none of them fits",
            "both sides keep boundary faces, and the inside-count joins them; where the field jumps across (cell "
            "data), an exit "
            "goes before the entry that it touches");
  TetMesh mesh = merged(boxFromTo(Vec3(-1, -1, -1), Vec3(0, 1, 1), 1), boxFromTo(Vec3(0, -1, -1), Vec3(1.0), 3));
  mesh.pointFields = {Field{"s", 1, linearField(mesh.points, Vec3(0.2, 0.15, -0.1))}};
  expectCells(mesh);
  expectCells(withCellData(mesh));
}

/// What is told of a gap between two boxes.
class CellGaps : public CellsTest {
 protected:
  void expectGap(double gap) {
    tellCells(
        "two boundaries so near that rounding may put the entry before the exit: a mark in a fragment alone loses "
        "the next segment, and with cell data it took the scalar of nothing",
        "a running count of entries and exits; what is nearer than 1e-6 stays in the order of the faces");
    expectBothData(twoBoxes(2, gap));
  }
};
TEST_F(CellGaps, Of1e3) { expectGap(1e-3); }
TEST_F(CellGaps, Of1e5) { expectGap(1e-5); }
TEST_F(CellGaps, Of1e6) { expectGap(1e-6); }
TEST_F(CellGaps, Of1e7) { expectGap(1e-7); }
TEST_F(CellGaps, Of1e9) { expectGap(1e-9); }
TEST_F(CellGaps, None) { expectGap(0); }

}  // namespace
}  // namespace havs::test
