// What must not decide a picture: the file's order, threads, tiles, the run.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "core/parallel.h"
#include "hard/like_plain.h"
#include "reference/reference_renderer.h"

namespace havs::test {
namespace {

constexpr const char* kGroup = "Ties";

/// Pictures of one order of the faces are the same numbers in the same order, to the last bit.
constexpr double kSameBits = 0;

/// Of another order of points or corners, sums are taken in another order: float's rounding of numbers up to 1, some
/// tens of segments a ray.
constexpr double kRounding = 5e-6;

using Generator = std::mt19937;

std::vector<Index> shuffled(std::size_t count, Generator& random) {
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), Index{0});
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

TetMesh withCellsShuffled(TetMesh mesh, Generator& random) {
  std::shuffle(mesh.tetrahedra.begin(), mesh.tetrahedra.end(), random);
  return mesh;
}

TetMesh withPointsShuffled(const TetMesh& mesh, Generator& random) {
  TetMesh other = mesh;
  const std::vector<Index> place = shuffled(mesh.points.size(), random);
  for (std::size_t i = 0; i < place.size(); ++i) {
    other.points[place[i]] = mesh.points[i];
    other.pointFields[0].values[place[i]] = mesh.pointFields[0].values[i];
  }
  for (Tetrahedron& cell : other.tetrahedra)
    for (Index& corner : cell) corner = place[corner];
  return other;
}

/// Corners of each cell in any of the 24 orders, half of which turn it over.
TetMesh withCornersShuffled(TetMesh mesh, Generator& random) {
  for (Tetrahedron& cell : mesh.tetrahedra) std::shuffle(cell.begin(), cell.end(), random);
  return mesh;
}

/// Only the 12 orders that leave a cell right-handed.
TetMesh withCornersTurned(TetMesh mesh, Generator& random) {
  for (Tetrahedron& cell : mesh.tetrahedra) {
    std::rotate(cell.begin() + 1, cell.begin() + 1 + random() % 3, cell.end());
    if (random() % 2 == 0) {
      std::swap(cell[0], cell[1]);
      std::swap(cell[2], cell[3]);
    }
  }
  return mesh;
}

class SamePicture : public LikePlainTest {
 protected:
  /// Three shuffles of each kind of mesh against the mesh as it was.
  template <class Shuffle>
  void expectWhateverTheFile(const Shuffle& shuffle, double bound) {
    for (const TetMesh& mesh : {plainMesh(4), touching(), regular()}) {
      const HardPicture plain = expectEveryWay(plainScene(), mesh);
      Generator random(7);
      for (int i = 0; i < 3; ++i) expectLike(plain, expectEveryWay(plainScene(), shuffle(mesh, random)), bound);
    }
  }
  /// Two boxes that touch at the same scalars.
  static TetMesh touching() { return withField(twoBoxes(3, 0)); }
  /// Cells whose centroids are at equal distances by the dozen.
  static TetMesh regular() { return withField(box(4, Cut::five)); }
  static TetMesh withField(TetMesh mesh) {
    mesh.pointFields = {Field{"s", 1, pointValues(mesh.points, [](const Vec3& p) {
                                return 0.5 + 0.3 * std::sin(2 * p.x + p.y) - 0.1 * p.z;
                              })}};
    return mesh;
  }
  /// Draws the plain scene by every way, once as it is and once for each of `changes`; all must be equal, bit for bit.
  struct Drawn {
    Scene scene = plainScene();
    PreparedScene prepared;
    View view;
    Drawn() {
      StageTimes stages;
      prepared = prepareScene(scene, plainMesh(4), stages);
      view = viewOf(scene, prepared);
    }
    Image by(const HardWay& way, const std::function<void(RenderPlan&)>& change = {}) const {
      return drawIn(way, scene, prepared, view, change).image;
    }
  };
};

TEST_F(SamePicture, WhateverTheOrderOfTheCells) {
  tell({kGroup, "cells that cannot be told apart are drawn as the file has them",
        "cells and points are numbered anew along a curve in space; of the file's order nothing is left"});
  expectWhateverTheFile(withCellsShuffled, kSameBits);
}

TEST_F(SamePicture, WhateverTheOrderOfThePoints) {
  tell({kGroup, "sums over the corners of a face depend on the order of its corners by rounding",
        "corners are taken in the order of numbers that follow space, not the file"});
  expectWhateverTheFile(withPointsShuffled, kSameBits);
}

TEST_F(SamePicture, WhateverTheOrderOfTheCorners) {
  tell({kGroup, "a face's first corner is another: interpolation rounds differently",
        "differences stay within float's rounding"});
  expectWhateverTheFile(withCornersTurned, kRounding);
}

TEST_F(SamePicture, WhateverTheHandOfTheCells) {
  tell({kGroup, "half of the cells turned over: their faces look the wrong way",
        "turned cells are turned back on reading, and counted"});
  expectWhateverTheFile(withCornersShuffled, kRounding);
}

TEST_F(SamePicture, TwiceBitForBit) {
  tell({kGroup, "threads that race for places in a list or a buffer, or memory that nobody has set",
        "each pixel's numbers are made in one order, whoever makes them: two pictures are equal bit for bit"});
  const Drawn drawn;
  for (const HardWay& way : hardWays()) {
    const Image first = drawn.by(way);
    for (int i = 0; i < 3; ++i) expectSame(way.group + ", again", first, drawn.by(way), kSameBits);
  }
}

TEST_F(SamePicture, WhateverTheThreads) {
  tell({kGroup, "sums over parts, one a thread, depend on how many there are",
        "loops write to places of their own, and what is joined is joined exactly"});
  const Drawn drawn;
  StageTimes stages;
  const auto truth = [&] { return makeReferenceRenderer(drawn.prepared)->draw(drawn.view, stages).image; };
  const Image reference = truth();
  std::vector<Image> first;
  for (const HardWay& way : hardWays()) first.push_back(drawn.by(way));
  for (const std::size_t threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    expectSame("reference", reference, truth(), kSameBits);
    const Drawn again;  // mesh, frame, faces and order by so many threads, too
    for (std::size_t i = 0; i < first.size(); ++i)
      expectSame(hardWays()[i].group, first[i], again.by(hardWays()[i]), kSameBits);
  }
}

TEST_F(SamePicture, WhateverTheTilesOfTheNativeDevice) {
  tell({kGroup, "a place relative to the tile is rounded differently in each tile",
        "faces are set up relative to their own first pixels in the picture"});
  const Drawn drawn;
  for (const HardWay& way : hardWays()) {
    if (way.group != "native") continue;
    const Image whole = drawn.by(way);
    for (const int side : {4, 8, 16, 32, 128})
      expectSame("native", whole, drawn.by(way, [&](RenderPlan& plan) { plan.tileWidth = plan.tileHeight = side; }),
                 kSameBits);
  }
}

TEST_F(SamePicture, WhateverTheTilesOfOpenGl) {
  tell({kGroup, "corners are snapped to a grid of 1/256 pixel in each tile's own coordinates",
        "the a-buffer cuts tiles out by scissors, bit for bit; the k-buffer's tiles are pictures of their own, within "
        "what the grid moves"});
  const Drawn drawn;
  for (const HardWay& way : hardWays()) {
    if (way.group == "native") continue;
    const Image whole = drawn.by(way);
    const bool list = way.group == "a-buffer";  // its tiles go by the number of fragments
    // The k-buffer's: as tests/gl/kbuffer_agreement_test.cpp.
    const auto cut = [&](RenderPlan& plan) {
      if (list) {
        plan.mostFragments = 2000;
      } else {
        plan.tileWidth = 20;
        plan.tileHeight = 16;
      }
    };
    expectSame(way.group, whole, drawn.by(way, cut), list ? kSameBits : 1e-4);
  }
}

TEST_F(SamePicture, WhateverTheTilesOfTheReference) {
  tell({kGroup, "tiles decide which cells are looked at together", "each ray sorts its own segments"});
  const Drawn drawn;
  const auto whole = referencePixels(drawn.prepared, drawn.view);
  for (const ReferenceTiles& tiles : {ReferenceTiles{1, 1e6}, ReferenceTiles{7, 1e6}, ReferenceTiles{64, 50}}) {
    const auto cut = referencePixels(drawn.prepared, drawn.view, tiles);
    double most = 0;
    for (std::size_t i = 0; i < whole.size(); ++i)
      for (std::size_t c = 0; c < 4; ++c) most = std::max(most, std::abs(whole[i][c] - cut[i][c]));
    expectAtMost("reference, in double", most, kSameBits);
  }
}

TEST_F(SamePicture, PartsInEitherOrder) {
  tell({kGroup, "of two parts that touch, the one that the file has first is drawn first",
        "the order of parts is made of their places"});
  const TetMesh left = withField(box(2, Cut::six, 0.2, 5));
  TetMesh right = left;
  for (Vec3& p : right.points) p.x += 2;
  right = withField(right);
  const auto both = [](const TetMesh& a, const TetMesh& b) { return withField(merged(a, b)); };
  expectLike(expectEveryWay(plainScene(), both(left, right)), expectEveryWay(plainScene(), both(right, left)),
             kRounding);
}

}  // namespace
}  // namespace havs::test
