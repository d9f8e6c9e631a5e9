#include "render/effects.h"

#include "render/effect_parts.h"
#include "render/overlay_effects.h"
#include "scene/clip_scene.h"

namespace havs {
namespace {

/// The scalar at a share of the domain.
double atShare(const EffectData& data, double share) { return (1 - share) * data.domain[0] + share * data.domain[1]; }

}  // namespace

std::span<const Effect> effects() {
  static const std::vector<Effect> rows{
      {.name = "clipping",
       .description = "the part of the mesh within clip planes and boxes",
       .wanted = [](const Scene& scene) { return !scene.clipPlanes.empty() || !scene.clipBoxes.empty(); },
       .add =
           [](Scene& scene, const EffectData& data) {
             scene.clipPlanes.push_back({data.center, {1, 0.5, 0.25}});
           },
       .remove = [](Scene& scene) { scene.clipPlanes.clear(), scene.clipBoxes.clear(); },
       .check = checkClipping,
       .plan = planClipping},
      {.name = "threshold",
       .description = "only the cells whose data lie in a range",
       .wanted = [](const Scene& scene) { return scene.threshold.has_value(); },
       .add =
           [](Scene& scene, const EffectData& data) {
             scene.threshold = {{atShare(data, 0.25), data.domain[1]}};
           },
       .remove = [](Scene& scene) { scene.threshold.reset(); },
       .check = checkClipping,
       .plan = planThreshold},
      {.name = "lighting",
       .description =
           "ambient, diffuse and specular light by the gradient of the scalar; shadows and occlusion imply it",
       .wanted = [](const Scene& scene) { return scene.lighting || scene.shadows || scene.occlusion; },
       .add = [](Scene& scene, const EffectData&) { scene.lighting.emplace(); },
       .remove = [](Scene& scene) { scene.lighting.reset(), scene.shadows = false, scene.occlusion.reset(); },
       .check = checkLighting,
       .light = addLighting,
       .plan = planLighting},
      {.name = "silhouettes",
       .description = "light fades where the gradient is across the ray",
       .wanted = [](const Scene& scene) { return scene.lighting && scene.lighting->silhouettes != 0; },
       .add =
           [](Scene& scene, const EffectData&) {
             (scene.lighting ? *scene.lighting : scene.lighting.emplace()).silhouettes = 0.5;
           },
       .remove =
           [](Scene& scene) {
             if (scene.lighting) scene.lighting->silhouettes = 0;
           },
       .check = checkLighting,
       .light = addSilhouettes,
       .plan = planSilhouettes},
      {.name = "modulation",
       .description = "extinction fades where the scalar hardly changes",
       .wanted = [](const Scene& scene) { return scene.modulation != 0; },
       .add = [](Scene& scene, const EffectData&) { scene.modulation = 0.5; },
       .remove = [](Scene& scene) { scene.modulation = 0; },
       .check = checkModulation,
       .light = addModulation,
       .plan = planModulation},
      {.name = "ambient occlusion",
       .description = "ambient light is dimmed by what is all around a point",
       .wanted = [](const Scene& scene) { return scene.occlusion.has_value(); },
       .add = [](Scene& scene, const EffectData&) { scene.occlusion.emplace(); },
       .remove = [](Scene& scene) { scene.occlusion.reset(); },
       .check = checkOcclusion,
       .light = addOcclusion,
       .plan = planOcclusion},
      {.name = "shadows",
       .description = "lights are dimmed by what lies between them and a point",
       .wanted = [](const Scene& scene) { return scene.shadows; },
       .add = [](Scene& scene, const EffectData&) { scene.shadows = true; },
       .remove = [](Scene& scene) { scene.shadows = false; },
       .check = checkShadows,
       .light = addShadows,
       .plan = planShadows},
      {.name = "ambient scattering",
       .description = "light that is scattered around a point is added",
       .wanted = [](const Scene& scene) { return scene.scattering.has_value(); },
       .add = [](Scene& scene, const EffectData&) { scene.scattering.emplace(); },
       .remove = [](Scene& scene) { scene.scattering.reset(); },
       .check = checkScattering,
       .light = addScattering,
       .plan = planScattering},
      {.name = "isosurfaces",
       .description = "surfaces of one value of the field, opaque or translucent",
       .wanted = [](const Scene& scene) { return !scene.isosurfaces.empty(); },
       .add = [](Scene& scene, const EffectData& data) { scene.isosurfaces.push_back({.value = atShare(data, 0.5)}); },
       .remove = [](Scene& scene) { scene.isosurfaces.clear(); },
       .check = checkIsosurfaceScene,
       .plan = planIsosurfaces},
      {.name = "outline",
       .description = "the edges of the box around the mesh",
       .wanted = [](const Scene& scene) { return scene.overlays.outline.has_value(); },
       .add = [](Scene& scene, const EffectData&) { scene.overlays.outline.emplace(); },
       .remove = [](Scene& scene) { scene.overlays.outline.reset(); },
       .check = checkOutlineScene,
       .plan = planOutline},
      {.name = "surface",
       .description = "the mesh's boundary faces, opaque or translucent",
       .wanted = [](const Scene& scene) { return scene.overlays.surface.has_value(); },
       .add = [](Scene& scene, const EffectData&) { scene.overlays.surface.emplace(); },
       .remove = [](Scene& scene) { scene.overlays.surface.reset(); },
       .check = checkSurfaceScene,
       .plan = planSurface},
      {.name = "wire frame",
       .description = "the edges of these faces",
       .wanted = [](const Scene& scene) { return scene.overlays.wireFrame.has_value(); },
       .add = [](Scene& scene, const EffectData&) { scene.overlays.wireFrame.emplace(); },
       .remove = [](Scene& scene) { scene.overlays.wireFrame.reset(); },
       .check = checkWireFrameScene,
       .plan = planWireFrame},
  };
  return rows;
}

LightPlan lightPlanOf(const Scene& scene) {
  LightPlan light;
  for (const Effect& effect : effects())
    if (effect.light != nullptr && effect.wanted(scene)) effect.light(light, scene);
  return light;
}

Payload payloadOf(const Scene& scene) { return lightPlanOf(scene).lit ? Payload::lit : lookupOf(scene).carries; }

}  // namespace havs
