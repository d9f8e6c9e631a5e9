// Cells of bad shape: slivers, needles, caps, flat and inverted ones, of edges of very different length.
#include "hard/cell_checks.h"
#include "hard/hard_meshes.h"

namespace havs::test {
namespace {

using CellShapes = CellsTest;

TEST_F(CellShapes, Slivers1e3) {
  tellCells("x", "y");
  expectBothData(sliverLayer(4, 1e-3));
}
TEST_F(CellShapes, Slivers1e6) {
  tellCells("x", "y");
  expectBothData(sliverLayer(4, 1e-6));
}
TEST_F(CellShapes, Slivers1e9) {
  tellCells("x", "y");
  expectBothData(sliverLayer(4, 1e-9));
}
TEST_F(CellShapes, Graded) {
  tellCells("x", "y");
  expectBothData(gradedGrid(6, 1e-6));
}
TEST_F(CellShapes, Layers) {
  tellCells("x", "y");
  expectBothData(boundaryLayers(6, 1e4));
}

}  // namespace
}  // namespace havs::test
