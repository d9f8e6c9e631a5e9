#pragma once
// A column of thin prisms, each of three tetrahedra, seen along its axis.
#include "hard/hard_case.h"
#include "support/meshes.h"

namespace havs::test {

/// `layers` triangular prisms, one on the other, from z = -1/2 to 1/2. The field is z + 1/2.
inline TetMesh layeredColumn(int layers) {
  TetMesh mesh;
  std::vector<double> values;
  for (int k = 0; k <= layers; ++k) {
    const double share = static_cast<double>(k) / layers;
    for (const auto& [x, y] : {std::pair{-1.0, -0.6}, {1.0, -0.6}, {0.0, 1.2}}) {
      mesh.points.push_back({x, y, share - 0.5});
      values.push_back(share);
    }
  }
  for (Index k = 0; k < static_cast<Index>(layers); ++k) {
    const Index a = 3 * k, b = a + 1, c = a + 2, aTop = a + 3, bTop = a + 4, cTop = a + 5;
    mesh.tetrahedra.insert(mesh.tetrahedra.end(), {{a, b, c, aTop}, {b, c, aTop, bTop}, {c, bTop, aTop, cTop}});
  }
  for (std::size_t cell = 0; cell < 3; ++cell)
    if (volume(mesh, cell) < 0)
      for (std::size_t i = cell; i < mesh.tetrahedra.size(); i += 3)
        std::swap(mesh.tetrahedra[i][0], mesh.tetrahedra[i][1]);
  mesh.sourceCells = mesh.tetrahedra.size();
  mesh.pointFields = {Field{"s", 1, std::move(values)}};
  return mesh;
}

/// Looks down the column, a little slanted, by parallel rays: all of them go through every layer.
inline Camera alongColumn() {
  Camera camera;
  camera.projection = Projection::orthographic;
  camera.azimuth = 4;
  camera.elevation = 3;
  camera.target = Vec3(0.0);
  camera.viewHeight = 0.4;
  return camera;
}

inline Scene columnScene(int size = 4) {
  Scene scene = hardScene(size);
  scene.camera = alongColumn();
  // (r, g, b) at the far end, at the near end; extinction 1 per mesh unit.
  scene.transferFunction = transferFile(transferOf({{0, 0.2, 0.9, 0.1, 1}, {1, 0.9, 0.3, 0.6, 1}}));
  return scene;
}

/// What each pixel shows, in closed form.
inline std::array<double, 4> colorOfColumn(const View& view) {
  const double depth = 1 / std::abs(view.forward.z);
  const double alpha = -std::expm1(-depth), psi = alpha / depth;
  const double front = 1 - psi, back = psi - std::exp(-depth);
  return {0.9 * front + 0.2 * back, 0.3 * front + 0.9 * back, 0.6 * front + 0.1 * back, alpha};
}

/// The largest difference of any channel of any pixel from it.
inline double offFromColumn(const Image& image, const View& view) {
  const std::array<double, 4> expected = colorOfColumn(view);
  double most = 0;
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    const double difference = std::abs(double{image.rgba[i]} - expected[i % 4]);
    if (!(difference <= most)) most = difference;
  }
  return most;
}

}  // namespace havs::test
