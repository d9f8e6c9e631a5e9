#include "core/error.h"
#include "light/light_plan.h"
#include "render/plan.h"

namespace havs {
namespace {

constexpr std::size_t kBytesPerNumber = 4;

void checkAtLeastZero(double value, const std::string& name) {
  if (!(value >= 0 && value <= 1e6)) failInput(name + " must lie between 0 and 1000000", "lighting");
}

void planRows(LightPlan& light, bool shadows) {
  int next = LightPlan::kGradient + 3;
  if (light.occlusion) light.occlusionAt = next++;
  if (light.scattering) light.scatteredAt = next++;
  if (shadows) {
    light.shadowsAt = next;
    next += static_cast<int>(light.lights.size());
  }
  light.rowLength = next;
}

void listDefines(RenderPlan& plan) {
  const LightPlan& light = plan.light;
  auto define = [&](const char* name, int value) { plan.defines.push_back({name, std::to_string(value)}); };
  define("HAVS_LIT", 1);
  define("HAVS_LIGHT_VECTORS", (light.rowLength + 3) / 4);
  define("HAVS_LIGHTS", static_cast<int>(light.lights.size()));
  if (light.phong) define("HAVS_PHONG", 1);
  if (light.modulation > 0) define("HAVS_MODULATION", 1);
  if (light.occlusionAt >= 0) define("HAVS_OCCLUSION_AT", light.occlusionAt);
  if (light.scatteredAt >= 0) define("HAVS_SCATTERED_AT", light.scatteredAt);
  if (light.shadowsAt >= 0) define("HAVS_SHADOWS_AT", light.shadowsAt);
}

void listItems(RenderPlan& plan, const SceneFacts& facts, bool shadows) {
  const LightPlan& light = plan.light;
  const std::string lit = light.phong        ? "the scene is lit"
                          : light.scattering ? "light is scattered"
                                             : "extinction is modulated";
  auto add = [&](const std::string& name, const std::string& stage, const std::string& reason, int numbers) {
    addItem(plan, PlanKind::precomputation, name, stage, reason, kBytesPerNumber * static_cast<std::size_t>(numbers),
            "point", facts.points);
  };
  add("gradients at the points", "gradients", lit + " by the gradient of the scalar", 3);
  if (shadows || light.occlusion || light.scattering)
    addItem(plan, PlanKind::precomputation, "the mesh as light goes through it", "tracer", "light is traced");
  if (light.occlusion) add("ambient occlusion at the points", "occlusion", "the scene asks for it", 1);
  if (shadows)
    add("transmittance from each light to the points", "shadows", "the scene asks for shadows",
        static_cast<int>(light.lights.size()));
  if (light.scattering) {
    addItem(plan, PlanKind::table, "scattered light over optical radius and angle", "scattering",
            "the scene asks for ambient scattering");
    add("scattered light at the points", "scattering", "the scene asks for ambient scattering", 1);
  }
}

}  // namespace

void checkLight(const Scene& scene) {
  if (scene.lights.size() > kMostLights)
    failInput("a scene takes at most " + std::to_string(kMostLights) + " lights", "lights");
  for (const SceneLight& light : scene.lights) checkAtLeastZero(light.intensity, "the intensity of a light");
  if (scene.lighting) {
    checkAtLeastZero(scene.lighting->ambient, "ambient");
    checkAtLeastZero(scene.lighting->diffuse, "diffuse");
    checkAtLeastZero(scene.lighting->specular, "specular");
    checkRange(scene.lighting->shininess, 0, 1000, "shininess");
    checkRange(scene.lighting->silhouettes, 0, 1, "silhouettes");
  }
  if (scene.occlusion) {
    checkRange(scene.occlusion->directions, 1, 4096, "the number of directions of ambient occlusion");
    if (!(scene.occlusion->radius > 0 && scene.occlusion->radius <= 2))
      failInput("the radius of ambient occlusion must lie above 0, up to 2 bounding radii", "ambient occlusion");
  }
  if (scene.scattering) {
    if (!(scene.scattering->radius > 0 && scene.scattering->radius <= 2))
      failInput("the radius of ambient scattering must lie above 0, up to 2 bounding radii", "scattering");
    if (!(scene.scattering->albedo >= 0 && scene.scattering->albedo < 1))
      failInput("the albedo must lie from 0 to below 1", "scattering");
    checkRange(scene.scattering->anisotropy, -0.95, 0.95, "the anisotropy of scattering");
  }
  checkRange(scene.modulation, 0, 1, "the modulation by the gradient");
}

bool isLit(const Scene& scene) {
  return scene.lighting || scene.shadows || scene.occlusion || scene.scattering || scene.modulation > 0;
}

LightPlan lightPlanOf(const Scene& scene) {
  LightPlan light;
  light.lit = isLit(scene);
  if (!light.lit) return light;
  light.phong = scene.lighting || scene.shadows || scene.occlusion;
  if (scene.lighting) light.lighting = *scene.lighting;
  light.lights = scene.lights;
  if (light.lights.empty()) light.lights.push_back({});
  light.modulation = scene.modulation;
  light.occlusion = scene.occlusion;
  light.scattering = scene.scattering;
  planRows(light, scene.shadows);
  return light;
}

void planLight(RenderPlan& plan, const Scene& scene, const SceneFacts& facts) {
  plan.light = lightPlanOf(scene);
  if (!plan.light.lit) return;
  plan.lookup.carries = Payload::lit;
  listDefines(plan);
  listItems(plan, facts, scene.shadows);
}

}  // namespace havs
