// Light that fragments carry: each effect's part of it, of the numbers of points that it is made of, and of the plan.
#include <algorithm>

#include "core/error.h"
#include "render/effect_parts.h"

namespace havs {
namespace {

constexpr std::size_t kBytesPerNumber = 4;

/// Takes the next `count` numbers of a row: their place.
int takeNumbers(LightPlan& light, int count) {
  light.lit = true;
  const int place = light.rowLength;
  light.rowLength += count;
  return place;
}

void needGradient(LightPlan& light) {
  if (light.gradientAt < 0) light.gradientAt = takeNumbers(light, 3);
}

/// The scene's, or one head light.
void needLights(LightPlan& light, const Scene& scene) {
  light.lights = scene.lights;
  if (light.lights.empty()) light.lights.push_back({});
}

int lightCount(const RenderPlan& plan) { return static_cast<int>(plan.light.lights.size()); }

/// Whether it was not there yet.
bool defineOnce(RenderPlan& plan, const std::string& name, int value = 1) {
  if (std::any_of(plan.defines.begin(), plan.defines.end(), [&](const auto& other) { return other.name == name; }))
    return false;
  plan.defines.push_back({name, std::to_string(value)});
  return true;
}

/// `count` numbers of each point, computed for the scene or the view.
void addNumbers(RenderPlan& plan, const SceneFacts& facts, const std::string& name, const std::string& stage,
                const std::string& reason, int count) {
  addItem(plan, PlanKind::precomputation, name, stage, reason, kBytesPerNumber * static_cast<std::size_t>(count),
          "point", facts.points);
}

/// That fragments carry light; `gradient`: also by the gradient.
void planLit(RenderPlan& plan, const SceneFacts& facts, bool gradient, const std::string& reason) {
  defineOnce(plan, "HAVS_LIT");
  defineOnce(plan, "HAVS_LIGHT_VECTORS", (plan.light.rowLength + 3) / 4);
  if (gradient && defineOnce(plan, "HAVS_GRADIENT_AT", plan.light.gradientAt))
    addNumbers(plan, facts, "gradients at the points", "gradients", reason + " by the gradient of the scalar", 3);
}

void planTracer(RenderPlan& plan) {
  const std::string name = "the mesh as light goes through it";
  if (std::none_of(plan.items.begin(), plan.items.end(), [&](const PlanItem& item) { return item.name == name; }))
    addItem(plan, PlanKind::precomputation, name, "tracer", "light is traced");
}

}  // namespace

void addLighting(LightPlan& light, const Scene& scene) {
  light.phong = true;
  if (scene.lighting) light.lighting = *scene.lighting;
  needLights(light, scene);
  needGradient(light);
}

void addSilhouettes(LightPlan& light, const Scene&) { needGradient(light); }

void addModulation(LightPlan& light, const Scene& scene) {
  light.modulation = scene.modulation;
  needGradient(light);
}

void addOcclusion(LightPlan& light, const Scene& scene) {
  light.occlusion = scene.occlusion;
  light.occlusionAt = takeNumbers(light, 1);
}

void addShadows(LightPlan& light, const Scene& scene) {
  needLights(light, scene);
  light.shadowsAt = takeNumbers(light, static_cast<int>(light.lights.size()));
}

void addScattering(LightPlan& light, const Scene& scene) {
  needLights(light, scene);
  light.scattering = scene.scattering;
  light.scatteredAt = takeNumbers(light, 1);
}

void planLighting(RenderPlan& plan, const Scene&, const SceneFacts& facts, const Capabilities&) {
  planLit(plan, facts, true, "the scene is lit");
  defineOnce(plan, "HAVS_PHONG");
  defineOnce(plan, "HAVS_LIGHTS", lightCount(plan));
}

void planSilhouettes(RenderPlan& plan, const Scene&, const SceneFacts& facts, const Capabilities&) {
  planLit(plan, facts, true, "silhouettes are found");
  defineOnce(plan, "HAVS_SILHOUETTES");
}

void planModulation(RenderPlan& plan, const Scene&, const SceneFacts& facts, const Capabilities&) {
  planLit(plan, facts, true, "extinction is modulated");
  defineOnce(plan, "HAVS_MODULATION");
}

void planOcclusion(RenderPlan& plan, const Scene&, const SceneFacts& facts, const Capabilities&) {
  planLit(plan, facts, false, "");
  planTracer(plan);
  defineOnce(plan, "HAVS_OCCLUSION_AT", plan.light.occlusionAt);
  addNumbers(plan, facts, "ambient occlusion at the points", "occlusion", "the scene asks for it", 1);
}

void planShadows(RenderPlan& plan, const Scene&, const SceneFacts& facts, const Capabilities&) {
  planLit(plan, facts, false, "");
  planTracer(plan);
  defineOnce(plan, "HAVS_SHADOWS_AT", plan.light.shadowsAt);
  addNumbers(plan, facts, "transmittance from each light to the points", "shadows", "the scene asks for shadows",
             lightCount(plan));
}

void planScattering(RenderPlan& plan, const Scene&, const SceneFacts& facts, const Capabilities&) {
  const std::string reason = "the scene asks for ambient scattering";
  planLit(plan, facts, false, "");
  planTracer(plan);
  defineOnce(plan, "HAVS_SCATTERED_AT", plan.light.scatteredAt);
  addItem(plan, PlanKind::table, "scattered light over optical radius and angle", "scattering_table", reason);
  addNumbers(plan, facts, "scattered light at the points", "scattering", reason, 1);
}

}  // namespace havs
