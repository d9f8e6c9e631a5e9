// Fragments at one distance, and everything else that must not decide a picture.
#include <algorithm>
#include <numeric>

#include "core/arithmetic.h"
#include "hard/like_plain.h"

namespace havs::test {
namespace {

constexpr const char* kGroup = "Ties";

using Ties = HardPictureTest;

/// A field that jumps where the two boxes of twoBoxes(n, 0) touch.
TetMesh touchingBoxes(int n) {
  TetMesh mesh = twoBoxes(n, 0);
  // Points of the second box come behind those of the first.
  const std::size_t half = mesh.points.size() / 2;
  std::vector<double> values(mesh.points.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = (i < half ? 0.25 : 0.7) + 0.2 * mesh.points[i].x - 0.1 * mesh.points[i].y;
  mesh.pointFields = {Field{"s", 1, values}};
  return mesh;
}

TEST_F(Ties, TouchingBoxesOfDifferentScalars) {
  tell({kGroup,
        "the exit from one box and the entry into the other lie at one distance, in either order by rounding: with the "
        "entry first, the segment behind them began at the scalar of the box left behind",
        "where an exit follows an entry within 1e-6 inside another part, the exit leaves first"});
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Scene scene = plainScene();
    scene.camera.projection = projection;
    expectEveryWay(scene, touchingBoxes(4));
    scene.camera.azimuth = -70;
    expectEveryWay(scene, touchingBoxes(3));
  }
}

}  // namespace
}  // namespace havs::test
