// Light in other units: gradients, lights at places, what comes through the mesh.
#include "core/error.h"
#include "hard/like_plain.h"
#include "render/make_renderer.h"

namespace havs::test {
namespace {

constexpr const char* kGroup = "Scale and place";

class LitScale : public LikePlainTest {
 protected:
  /// The native device with k = 6 and the reference, in each of the units against plain ones.
  void expectLitLikePlain(const Scene& scene, const std::vector<Units>& all) {
    const TetMesh mesh = plainMesh(3);
    const auto [native, truth] = draw(scene, mesh);
    for (const Units& units : all) {
      SCOPED_TRACE(testing::Message() << "length " << units.length << ", scalar " << units.scalar);
      const auto [nativeThere, truthThere] = draw(sceneIn(units, scene), meshIn(units, mesh));
      expectSame("native against plain", native, nativeThere, kSameInAnyUnit);
      expectSame("reference against plain", truth, truthThere, kSameInAnyUnit);
      // As tests/image/light_test.cpp: colour times light bends between two knots of the transfer function.
      expectSame("native max", nativeThere, truthThere, 2e-3);
    }
  }

  struct Pictures {
    Image native, truth;
  };
  static Pictures draw(const Scene& scene, const TetMesh& mesh) {
    StageTimes stages;
    const PreparedScene prepared = prepareScene(scene, mesh, stages);
    const View view = viewOf(scene, prepared);
    Pictures pictures{drawIn({"native", "native", "native", "kbuffer", "topological", 6}, scene, prepared, view).image,
                      makeReference(scene, prepared)->draw(view, stages).image};
    for (const Image* image : {&pictures.native, &pictures.truth}) EXPECT_EQ(notAPicture(*image), "");
    return pictures;
  }
};

const std::vector<Units> kUnits{
    {.length = 1e-150}, {.length = 1e150}, {.length = 1e-12, .scalar = 1e30}, {.length = 1e12, .scalar = 1e-30}};

TEST_F(LitScale, Gradients) {
  tell({kGroup,
        "a gradient of 1e30 / 1e-12 leaves single precision, its square leaves double; one of 1e-42 is 0 in float",
        "gradients are of fractions of the domain in the mesh's frame, and of order 1 there"});
  Scene scene = plainScene();
  scene.lighting = Lighting{.silhouettes = 0.5};
  scene.modulation = 0.5;
  expectLitLikePlain(scene, kUnits);
}

TEST_F(LitScale, LightsAtPlaces) {
  tell({kGroup, "a light at 1e150 was refused, as if its distance were no number, whatever the mesh's unit",
        "lights go to the mesh's frame in double before any way is made of them, and are refused only 1e18 of its "
        "radii away, where squares leave float"});
  Scene scene = plainScene();
  scene.lighting.emplace();
  scene.lights = {{SceneLight::Kind::point, {3, 2, 4}, 0.6}, {SceneLight::Kind::point, {-5, 1, 3}, 0.5}};
  expectLitLikePlain(scene, kUnits);
  expectLitLikePlain(scene, {{.place = Vec3(2e6, -1e6, 3e6)}});
  scene.lights[0].place = Vec3(1e30, 0, 0);
  try {
    draw(scene, plainMesh(3));
    ADD_FAILURE() << "a light 1e30 of the mesh's radii away is drawn";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_NE(std::string(error.what()).find("farther from the mesh"), std::string::npos) << error.what();
  }
}

TEST_F(LitScale, DirectionsOfAnyLength) {
  tell({kGroup, "a direction longer than 1e30 was refused, as if its square were taken",
        "directions are divided by their largest component before they are normalised"});
  Scene scene = plainScene();
  scene.lighting.emplace();
  const auto drawnWith = [&](double length) {
    scene.lights = {{SceneLight::Kind::directional, length * Vec3(1, 2, -0.5), 1}};
    StageTimes stages;
    const PreparedScene prepared = prepareScene(scene, plainMesh(3), stages);
    const View view = viewOf(scene, prepared);
    return drawIn({"native", "native", "native", "kbuffer", "topological", 6}, scene, prepared, view).image;
  };
  const Image plain = drawnWith(1);
  for (const double length : {1e-300, 1e-20, 1e20, 1e300})
    expectSame("native against plain", plain, drawnWith(length), kSameInAnyUnit);
}

TEST_F(LitScale, OcclusionShadowsScattering) {
  tell({kGroup,
        "rays through the mesh from each point: their steps and ends in mesh units would need tolerances of a size",
        "they run in the mesh's frame, their radii are fractions of its own"});
  Scene scene = plainScene();
  scene.lighting.emplace();
  scene.shadows = true;
  scene.occlusion = AmbientOcclusion{.radius = 0.3, .directions = 16};
  scene.scattering = AmbientScattering{};
  scene.lights = {{SceneLight::Kind::point, {3, 2, 4}, 1}};
  expectLitLikePlain(scene, {{.length = 1e-150, .scalar = 1e30}});
}

}  // namespace
}  // namespace havs::test
