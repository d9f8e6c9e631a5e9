// Cells that hide each other in a ring, so that no order of the cells is right for every ray. Each test proves that of
// its mesh, from the segments of the reference.
#include "hard/cell_checks.h"
#include "hard/hard_meshes.h"

namespace havs::test {
namespace {

class CellCycles : public CellsTest {
 protected:
  /// Along z, where the rings close.
  static Scene seenAlongZ() {
    Scene scene = rampScene();
    scene.camera.azimuth = scene.camera.elevation = 0;
    return scene;
  }

  void expectRing(const TetMesh& mesh, std::size_t least, bool connected) {
    const HardPicture picture = expectCells(withPointData(mesh), {}, seenAlongZ());
    const std::size_t cycle = shortestCycle(picture.prepared, picture.view);
    EXPECT_GE(cycle, least);
    expectAtMost("cells of a ring of at least " + std::to_string(least) + " not found",
                 static_cast<double>(least) - static_cast<double>(cycle), 0);
    // Parts that do not touch have no relation for the search to find.
    EXPECT_EQ(picture.by("native k 6 topological").cycles > 0, connected);
    expectCells(withCellData(mesh), cellDataBounds(), seenAlongZ());
  }
};

const char* const kTrouble =
    "each cell is in front of the next, round and round: no order of cells is right for all rays";
const char* const kSeparate =
    "each pixel's fragments fit into the k-buffer, which orders them by distance; late ones of k 2 are counted";
const char* const kConnected =
    "the relation across the face that takes least of the picture is cut, and counted; the k-buffer mends its pixels";

TEST_F(CellCycles, ThreeSticks) {
  tellCells(kTrouble, kSeparate);
  expectRing(ringOfSticks(3), 3, false);
}
TEST_F(CellCycles, FourSticks) {
  tellCells(kTrouble, kSeparate);
  expectRing(ringOfSticks(4), 4, false);
}
TEST_F(CellCycles, ARingOf24Sticks) {
  tellCells(kTrouble, kSeparate);
  expectRing(ringOfSticks(24), 24, false);
}
TEST_F(CellCycles, ThreeBricksJoined) {
  tellCells(kTrouble, kConnected);
  expectRing(ringOfBricks(3), 3, true);
}
TEST_F(CellCycles, FourBricksJoined) {
  tellCells(kTrouble, kConnected);
  expectRing(ringOfBricks(4), 4, true);
}
TEST_F(CellCycles, ARingOf24BricksJoined) {
  tellCells(kTrouble, kConnected);
  expectRing(ringOfBricks(24), 24, true);
}

}  // namespace
}  // namespace havs::test
