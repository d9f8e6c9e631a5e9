// What light is refused for: numbers out of range, and modes, methods and lookups whose fragments cannot be lit.
#include "core/error.h"
#include "core/vec.h"
#include "render/effect_parts.h"

namespace havs {
namespace {

constexpr double kMostOfCoefficient = 1e6;
constexpr int kMostShininess = 1000;
constexpr int kMostDirections = 4096;
constexpr double kMostRadius = 2;  // of the bounding radius: the ball holds the mesh
constexpr double kMostAnisotropy = 0.95;

void checkAtLeastZero(double value, const std::string& name) {
  if (!(value >= 0 && value <= kMostOfCoefficient)) failInput(name + " must lie between 0 and 1000000", "lighting");
}

void checkRadius(double radius, const std::string& effect, const std::string& where) {
  if (!(radius > 0 && radius <= kMostRadius))
    failInput("the radius of " + effect + " must lie above 0, up to 2 bounding radii", where);
}

/// That fragments of the scene's picture can carry light.
void checkCarriesLight(const Scene& scene) {
  const Mode& shown = mode(scene.mode);
  if (shown.gathering != Gathering::composite)
    failInput("the mode " + shown.name + " knows no light", "--mode", "leave lighting out, or draw with --mode volume");
  if (const Lookup chosen = lookupOf(scene); chosen.carries == Payload::color)
    failInput("the lookup '" + chosen.name + "' has fragments carry colours, which cannot be lit", "--lookup",
              "draw with another one");
  if (const VisibilityMethod& method = visibilityMethod(scene.visibility); !method.carriesLight)
    failInput("the visibility method " + method.name + " does not draw lit scenes", "--visibility",
              "draw with --visibility " + methodsWith(&VisibilityMethod::carriesLight));
}

}  // namespace

void checkLights(const Scene& scene) {
  if (scene.lights.size() > kMostLights)
    failInput("a scene takes at most " + std::to_string(kMostLights) + " lights", "lights");
  for (const SceneLight& light : scene.lights) {
    checkAtLeastZero(light.intensity, "the intensity of a light");
    if (light.kind == SceneLight::Kind::head) continue;
    if (!isFinite(light.place))
      failInput("the place or direction of a light has a number that is not finite", "lights",
                "write point:X,Y,Z in mesh units, or directional:X,Y,Z");
    if (light.kind == SceneLight::Kind::directional && light.place == Vec3(0))
      failInput("a directional light has no direction", "lights", "give it a vector other than 0,0,0");
  }
}

void checkLighting(const Scene& scene) {
  checkCarriesLight(scene);
  if (!scene.lighting) return;  // implied
  checkAtLeastZero(scene.lighting->ambient, "ambient");
  checkAtLeastZero(scene.lighting->diffuse, "diffuse");
  checkAtLeastZero(scene.lighting->specular, "specular");
  checkRange(scene.lighting->shininess, 0, kMostShininess, "shininess");
  checkRange(scene.lighting->silhouettes, 0, 1, "silhouettes");
}

void checkModulation(const Scene& scene) {
  checkCarriesLight(scene);
  checkRange(scene.modulation, 0, 1, "the modulation by the gradient");
}

void checkOcclusion(const Scene& scene) {
  checkCarriesLight(scene);
  checkRange(scene.occlusion->directions, 1, kMostDirections, "the number of directions of ambient occlusion");
  checkRadius(scene.occlusion->radius, "ambient occlusion", "ambient occlusion");
}

void checkShadows(const Scene& scene) { checkCarriesLight(scene); }

void checkScattering(const Scene& scene) {
  checkCarriesLight(scene);
  checkRadius(scene.scattering->radius, "ambient scattering", "scattering");
  if (!(scene.scattering->albedo >= 0 && scene.scattering->albedo < 1))
    failInput("the albedo must lie from 0 to below 1", "scattering");
  checkRange(scene.scattering->anisotropy, -kMostAnisotropy, kMostAnisotropy, "the anisotropy of scattering");
}

}  // namespace havs
