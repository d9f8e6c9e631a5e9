// Segments whose integral is hard: both ends alike, no length, opaque, steps.
#include "hard/hard_case.h"
#include "support/meshes.h"

namespace havs::test {
namespace {

using Segments = HardPictureTest;

TetMesh withPoints(TetMesh mesh, std::vector<double> values) {
  mesh.pointFields = {Field{"s", 1, std::move(values)}};
  return mesh;
}

TEST_F(Segments, BothEndsTheSameScalar) {
  tell({"Segments", "differences of integral functions are divided by back - front: 0 / 0",
        "the weights of a piece are functions of optical depths, which have no such quotient"});
  const TetMesh mesh = box(3, Cut::five);
  Scene scene = hardScene();
  scene.transferFunction = transferFile(transferOf({{0, 0.2, 0.4, 0.8, 0.3}, {1, 0.9, 0.5, 0.1, 1.3}}));
  expectEveryWay(scene, withPoints(mesh, constantField(mesh.points, 0.37)));
}

}  // namespace
}  // namespace havs::test
