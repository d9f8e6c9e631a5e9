#include "hard/cell_checks.h"
#include "hard/hard_meshes.h"

namespace havs::test {
namespace {

using CellTopology = CellsTest;

TEST_F(CellTopology, AroundPoint) {
  tellCells("x", "y");
  expectBothData(cellsAroundPoint(3));
}
TEST_F(CellTopology, AroundEdge) {
  tellCells("x", "y");
  expectBothData(cellsAroundEdge(500));
}
TEST_F(CellTopology, Separate) {
  tellCells("x", "y");
  expectBothData(separateCells(100, 3));
}
TEST_F(CellTopology, Shells) {
  tellCells("x", "y");
  expectBothData(shellsInShells(5));
}
TEST_F(CellTopology, Sticks) {
  tellCells("x", "y");
  Scene s = rampScene();
  s.camera.azimuth = 0;
  s.camera.elevation = 0;
  for (int n : {3, 4, 24}) {
    SCOPED_TRACE(n);
    expectBothData(ringOfSticks(n), {}, s);
  }
}
TEST_F(CellTopology, Bricks) {
  tellCells("x", "y");
  Scene s = rampScene();
  s.camera.azimuth = 0;
  s.camera.elevation = 0;
  for (int n : {3, 4, 24}) {
    SCOPED_TRACE(n);
    expectBothData(ringOfBricks(n), {}, s);
  }
}
TEST_F(CellTopology, Gap) {
  tellCells("x", "y");
  for (double n : {0.0, 1e-9, 1e-7, 1e-6, 1e-5, 1e-3}) {
    SCOPED_TRACE(n);
    expectBothData(twoBoxes(2, n));
  }
}

}  // namespace
}  // namespace havs::test
