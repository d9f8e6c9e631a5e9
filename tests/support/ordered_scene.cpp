#include "support/ordered_scene.h"

#include <utility>

#include "support/meshes.h"

namespace havs::test {

OrderedScene::OrderedScene(TetMesh m)
    : mesh(std::move(m)),
      faces(buildFaces(mesh)),
      frame(localFrame(mesh)),
      points(localPoints(mesh, frame)),
      scalars(smoothField(points)) {}

FaceOrder OrderedScene::order(const std::string& sort, const View& view) const {
  FaceOrder result;
  sortMethod(sort).make({points, mesh.tetrahedra, &faces})->sort(viewPoint(view), result);
  return result;
}

ReplayResult OrderedScene::replay(const std::string& sort, const View& view, int k, const SegmentColor& color) const {
  const FaceOrder faceOrder = order(sort, view);
  return test::replay({points, &faces, faceOrder.faces, scalars, view}, k, color);
}

std::vector<ReplayResult> OrderedScene::replay(const std::string& sort, const View& view,
                                               std::span<const int> ks) const {
  const FaceOrder faceOrder = order(sort, view);
  return test::replay({points, &faces, faceOrder.faces, scalars, view}, ks);
}

}  // namespace havs::test
