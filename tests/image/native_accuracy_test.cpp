// The native device against the reference with the lookup `exact`: both decide by the same exact rule which pixels a
// face covers, so that no mask stands between them and every pixel of the picture counts.
#include "image/meshes_drawn.h"
#include "image/native_scene.h"

namespace havs::test {
namespace {

/// What issue 4 promises for every mesh and camera. Roundings alone leave less, see below.
constexpr double kPromisedRmse = 5e-6, kPromisedMaximum = 5e-4;

Scene exactScene(const std::string& transfer, int size) {
  Scene scene;
  scene.transferFunction = transfer;
  scene.lookup = "exact";
  scene.width = scene.height = size;
  return scene;
}

class NativeAccuracy : public testing::TestWithParam<MeshDrawn> {
 protected:
  void SetUp() override {
    auto mesh = GetParam().make();
    if (!mesh)
      GTEST_SKIP() << "no such mesh here: TetGen is left out of the build, or there is no " << HAVS_SHARED_DATA;
    mesh_ = std::move(*mesh);
  }

  void expectWithin(const NativeScene& scene, double rmse, double maximum) {
    const Comparison comparison = scene.againstTruth();
    RecordProperty("rmse", std::to_string(comparison.rgba.rmse * 1e6) + "e-6");
    RecordProperty("max", std::to_string(comparison.rgba.max * 1e6) + "e-6");
    EXPECT_EQ(comparison.masked, 0u);
    EXPECT_LE(comparison.rgba.rmse, rmse);
    EXPECT_LE(comparison.rgba.max, maximum) << "at " << comparison.worstX << ',' << comparison.worstY;
    std::cout << GetParam().name << ": rmse " << comparison.rgba.rmse << ", max " << comparison.rgba.max << '\n';
  }

  TetMesh mesh_;
};

TEST_P(NativeAccuracy, Perspective) { expectWithin({exactScene("viridis", GetParam().size), mesh_}, 1e-6, 1e-5); }

TEST_P(NativeAccuracy, PerspectiveThreePeaks) {
  expectWithin({exactScene("three-peaks", GetParam().size), mesh_}, kPromisedRmse, kPromisedMaximum);
}

TEST_P(NativeAccuracy, OrthographicThreePeaks) {
  Scene scene = exactScene("three-peaks", GetParam().size);
  scene.camera.projection = Projection::orthographic;
  scene.camera.azimuth = 200;
  scene.camera.elevation = -35;
  expectWithin({scene, mesh_}, kPromisedRmse, kPromisedMaximum);
}

/// Along an axis, where many faces are seen edge on and many points lie on one ray.
TEST_P(NativeAccuracy, OrthographicAlongAnAxis) {
  Scene scene = exactScene("viridis", GetParam().size);
  scene.camera = {.projection = Projection::orthographic, .azimuth = 0, .elevation = 0};
  expectWithin({scene, mesh_}, 1e-6, 1e-5);
}

/// Wide, from close by.
TEST_P(NativeAccuracy, WideAngle) {
  Scene scene = exactScene("viridis", GetParam().size);
  scene.camera.azimuth = -110;
  scene.camera.elevation = 60;
  scene.camera.fieldOfView = 120;
  expectWithin({scene, mesh_}, 1e-6, 1e-5);
}

/// A place inside the bounding sphere and outside the mesh, in mesh units: the nearest to its centre of a grid.
std::optional<Vec3> placeBesideTheMesh(const PreparedScene& prepared) {
  std::optional<Vec3> best;
  double nearest = 0.98;  // local units: inside the sphere
  for (int i = -6; i <= 6; ++i)
    for (int j = -6; j <= 6; ++j)
      for (int k = -6; k <= 6; ++k) {
        const Vec3 place = Vec3{i, j, k} * 0.14 + Vec3{0.011, 0.007, 0.003};
        if (length(place) >= nearest || insideMesh(prepared, place)) continue;
        nearest = length(place);
        best = place;
      }
  if (best) best = prepared.frame.center + prepared.frame.radius * *best;
  return best;
}

/// From inside the bounding sphere, looking past the centre, so that parts of the mesh are behind the eye.
TEST_P(NativeAccuracy, EyeWithinTheBoundingSphere) {
  Scene scene = exactScene("viridis", GetParam().size);
  NativeScene drawn(scene, mesh_);
  const auto eye = placeBesideTheMesh(drawn.prepared);
  if (!eye) GTEST_SKIP() << "the mesh fills its bounding sphere";
  const Vec3 toCenter = drawn.prepared.frame.center - *eye;
  const Vec3 aside{-toCenter.y, toCenter.x, 0.3 * toCenter.z};
  scene.camera.eye = *eye;
  scene.camera.target = *eye + 0.6 * toCenter + aside;
  scene.camera.fieldOfView = 100;
  drawn.scene = scene;
  drawn.view = viewOf(scene, drawn.prepared);
  const auto behind = std::count_if(drawn.prepared.points.begin(), drawn.prepared.points.end(),
                                    [&](const Vec3& p) { return dot(p - drawn.view.eye, drawn.view.forward) < 0; });
  EXPECT_GT(behind, 0);
  const Image truth = drawn.truth();
  std::size_t seen = 0;
  for (std::size_t i = 3; i < truth.rgba.size(); i += 4) seen += truth.rgba[i] > 0 ? 1 : 0;
  EXPECT_GT(seen, truth.rgba.size() / 4 / 20);
  expectWithin(drawn, kPromisedRmse, kPromisedMaximum);
}

INSTANTIATE_TEST_SUITE_P(Meshes, NativeAccuracy, testing::ValuesIn(meshesDrawn()),
                         [](const testing::TestParamInfo<MeshDrawn>& row) { return row.param.name; });

}  // namespace
}  // namespace havs::test
