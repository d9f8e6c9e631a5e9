#pragma once
// A scene in other units, against itself in plain ones.
#include "hard/hard_case.h"
#include "hard/units.h"
#include "support/meshes.h"

namespace havs::test {

/// The bound of what a unit may change in a picture.
inline constexpr double kSameInAnyUnit = 1e-5;

/// A jittered box of edge 2 about the origin, its field in [0.05, 0.95].
inline TetMesh plainMesh(int n = 4) {
  TetMesh mesh = box(n, Cut::six, 0.25, 3);
  mesh.pointFields = {Field{"s", 1, pointValues(mesh.points, [](const Vec3& p) {
                              return 0.5 + 0.45 * std::sin(2.1 * p.x + 0.4) * std::cos(1.7 * p.y - 0.9 * p.z);
                            })}};
  return mesh;
}

/// The mean of each cell's corners as cell data.
inline TetMesh withCellMeans(TetMesh mesh) {
  const std::vector<double> values = mesh.pointFields.at(0).values;
  mesh.pointFields.clear();
  mesh.cellFields = {Field{"c", 1, {}}};
  for (const auto& [a, b, c, d] : mesh.tetrahedra)
    mesh.cellFields[0].values.push_back(0.25 * (values[a] + values[b] + values[c] + values[d]));
  return mesh;
}

inline Scene plainScene() {
  Scene scene = hardScene(48);
  scene.transferFunction = "rainbow";
  scene.unitLength = 0.4;
  scene.domain = {0, 1};
  return scene;
}

class LikePlainTest : public HardPictureTest {
 protected:
  /// Draws scene and mesh in each of the units in every way, and expects the pictures of the plain ones, which are
  /// drawn once. `bound`: of the difference in a channel, for each way.
  void expectLikePlain(const Scene& scene, const TetMesh& mesh, const std::vector<Units>& all,
                       const HardBounds& bounds = {}, double bound = kSameInAnyUnit) {
    const HardPicture plain = expectEveryWay(scene, mesh, bounds);
    for (const Units& units : all) {
      SCOPED_TRACE(testing::Message() << "length " << units.length << " at " << units.place.x << ", scalar "
                                      << units.scalar << " from " << units.offset);
      expectLike(plain, expectEveryWay(sceneIn(units, scene), meshIn(units, mesh), bounds), bound);
    }
  }

  /// The same way, the same picture.
  void expectLike(const HardPicture& plain, const HardPicture& other, double bound) {
    expectSame("reference against plain", plain.truth, other.truth, bound);
    ASSERT_EQ(plain.drawings.size(), other.drawings.size());
    for (std::size_t i = 0; i < plain.drawings.size(); ++i) {
      SCOPED_TRACE(plain.drawings[i].way.name);
      expectSame(plain.drawings[i].way.group + " against plain", plain.drawings[i].drawing.image,
                 other.drawings[i].drawing.image, bound);
    }
  }
};

}  // namespace havs::test
