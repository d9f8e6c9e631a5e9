// Cells of bad shape: slivers, needles, caps, wedges, edges and layers of very different size.
#include "hard/cell_checks.h"
#include "hard/hard_meshes.h"

namespace havs::test {
namespace {

using CellShapes = CellsTest;

/// The scalar of a fragment may be its neighbour's where floats cannot tell which of them is in front: a jump of the
/// colour, of any size.
const HardBounds kNearerThanFloats{.byDistance = 1};

const char* const kSliverTrouble =
    "both faces of a sliver lie at the same float distance: sorted by distance, either comes first, and the segment "
    "behind them took the sliver's scalar instead of the next cell's (here up to 0.07 of a channel with cell data, and "
    "0.007 with point data)";
const char* const kBelievedRemedy =
    "the topological order knows which face is first: fragments less than 1e-6 of the radius apart stay in the order "
    "in "
    "which they come. Ways that know distances only (centroid order, a-buffer) still show either";

TEST_F(CellShapes, SliversOfAspect1e3) {
  tellCells("cells a thousand times thinner than wide: a tolerance on volumes or distances takes them for nothing",
            "only what is flat to 1e-15 of its edge's cube is left out; distances are kept to 1e-7 of the radius");
  expectBothData(sliverLayer(4, 1e-3));
}

TEST_F(CellShapes, SliversOfAspect1e6) {
  tellCells(kSliverTrouble, kBelievedRemedy);
  expectBothData(sliverLayer(4, 1e-6), kNearerThanFloats);
}

TEST_F(CellShapes, SliversOfAspect1e9) {
  tellCells(kSliverTrouble, kBelievedRemedy);
  expectBothData(sliverLayer(4, 1e-9), kNearerThanFloats);
}

/// Every third cell of a box split about a point of these shares. Point data stay the same everywhere, so the picture
/// is that of the box.
class SplitCells : public CellsTest {
 protected:
  void expectSplit(const std::function<std::array<double, 4>(double)>& sharesOf) {
    const TetMesh whole = withPointData(box(3, Cut::five, 0.2));
    const HardPicture expected = expectCells(whole);
    for (const double least : {1e-3, 1e-6, 1e-9}) {
      SCOPED_TRACE(least);
      TetMesh mesh = whole;
      for (std::size_t c = 0; c < whole.tetrahedra.size(); c += 3) splitCell(mesh, c, sharesOf(least));
      const HardPicture picture = expectCells(mesh);
      expectSame("the truth of cells not split", picture.truth, expected.truth, 1e-6);
      expectCells(withCellData(mesh), cellDataBounds(kNearerThanFloats));
    }
  }
};

TEST_F(SplitCells, Needles) {
  tellCells(
      "cells with one edge of 1e-3, 1e-6 or 1e-9 of the others, three at a corner: edge functions of nearly equal "
      "points cancel, and faces are seen as lines",
      "edge functions whose sign rounding might hide are summed exactly; thin faces are drawn in double");
  expectSplit([](double e) { return std::array{1 - 3 * e, e, e, e}; });
}

TEST_F(SplitCells, Caps) {
  tellCells(
      "cells whose fourth point lies over the middle of the opposite face, 1e-3 to 1e-9 high: two surfaces nearer "
      "to each other than floats tell",
      kBelievedRemedy);
  expectSplit([](double e) { return std::array{e, (1 - e) / 3, (1 - e) / 3, (1 - e) / 3}; });
}

TEST_F(SplitCells, Wedges) {
  tellCells(
      "a point beside the middle of an edge: two cells around it with dihedral angles of 1e-3 to 1e-9, seen edge "
      "on from everywhere",
      kBelievedRemedy);
  expectSplit([](double e) { return std::array{0.5 - e, 0.5 - e, e, e}; });
}

TEST_F(CellShapes, EdgesFrom1e6To1InOneMesh) {
  tellCells(
      "edges from a millionth of the largest on: tolerances relative to the mesh swallow the small cells, those "
      "relative to a cell leave gaps between large ones",
      "no tolerance decides coverage; floats start from a face's own first pixel");
  expectBothData(gradedGrid(6, 1e-6), kNearerThanFloats);
}

TEST_F(CellShapes, EdgesFrom1e6To1SeenFromTheSmallOnes) {
  tellCells("the cells of edge 1e-6 fill the picture, the mesh is a million pictures wide",
            "faces are cut to the picture by the rasteriser in homogeneous coordinates; the eye stays outside");
  Scene scene = rampScene();
  scene.camera.eye = Vec3(-4, -3, -5);
  scene.camera.target = Vec3(0, 0, 0);
  expectBothData(gradedGrid(6, 1e-6), kNearerThanFloats, scene);
}

TEST_F(CellShapes, BoundaryLayersStretched10000To1) {
  tellCells("layers at a wall 10,000 times thinner than the cells are wide: centroids say nothing about order",
            "the topological order asks planes, not centroids; what is late in centroid order is counted");
  expectBothData(boundaryLayers(6, 1e4), kNearerThanFloats);
}

}  // namespace
}  // namespace havs::test
