#pragma once
// What the cases of the group "Cells" share: data for a mesh, and pictures whose truth is checked as well, against the
// cells clipped one by one in long double.
#include "hard/hard_case.h"
#include "support/meshes.h"

namespace havs::test {

/// The mesh with a smooth point field of [0, 1].
TetMesh withPointData(TetMesh mesh);
/// The mesh with a cell field of random values of [0, 1], far from those of the cells' neighbours.
TetMesh withCellData(TetMesh mesh, std::uint32_t seed = 1);

/// Extinction and colour linear in the scalar, so that the opacity of each ray has a closed form.
Scene rampScene(int size = 48);

/// Greatest difference of the truth's opacity from 1 - exp(-sum of length * mean extinction) over the cells that a ray
/// meets, a point in more than one of them belonging to that entered first. Every `stride`-th pixel each way.
double truthError(const HardPicture& picture, int stride = 3);

/// Pixels whose rays are in more than one cell at once, over more than `tolerance`; the three around them, too.
std::vector<unsigned char> overlapMask(const HardPicture& picture, double tolerance = 1e-9);

class CellsTest : public HardPictureTest {
 protected:
  void tellCells(const std::string& trouble, const std::string& remedy) { tell({"Cells", trouble, remedy}); }
  /// Draws in every way, and checks the truth (truthError).
  HardPicture expectCells(const TetMesh& mesh, const HardBounds& bounds = {}, const Scene& scene = rampScene());
  /// The same with point data, and with cell data.
  void expectBothData(const TetMesh& mesh, const HardBounds& bounds = {}, const Scene& scene = rampScene());
  /// Expects of the truths and of each way that the two pictures differ by at most `bound`.
  void expectSamePictures(const HardPicture& a, const HardPicture& b, double bound);
  /// Cells overlap: draws point data, and expects the bounds at the pixels whose rays are in one cell at a time; of the
  /// others that they are finite colours. Late pixels are left out, as in expectEveryWay.
  HardPicture expectRightBesideOverlaps(const TetMesh& mesh, const Scene& scene = rampScene());
  /// Expects so many defects of the kind, and that they are told in the report's notes.
  void expectDefects(const PreparedScene& prepared, const std::string& name, std::size_t count);
};

/// Bounds of cell data: colours jump at the edges of cells. Where the rasteriser's grid puts a pixel on the other side
/// of one, the difference is the jump: so each pixel's cause is looked for, and the percentile says nothing.
HardBounds cellDataBounds(HardBounds bounds = {});

/// How many cells the shortest ring has in which each is in front of the next on some ray of the view: then the cells
/// have no order. 0: there is no ring.
std::size_t shortestCycle(const PreparedScene& prepared, const View& view);

/// Count of a kind of defect that the scene's report gives.
std::size_t defectCount(const PreparedScene& prepared, const std::string& name);

}  // namespace havs::test
