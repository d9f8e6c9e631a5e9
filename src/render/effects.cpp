#include "render/effects.h"

#include "render/effect_parts.h"
#include "scene/clip_scene.h"

namespace havs {

std::span<const Effect> effects() {
  static const std::vector<Effect> rows{
      {.name = "clipping",
       .description = "the part of the mesh within clip planes and boxes",
       .wanted = [](const Scene& scene) { return !scene.clipPlanes.empty() || !scene.clipBoxes.empty(); },
       .check = checkClipping,
       .plan = planClipping},
      {.name = "threshold",
       .description = "only the cells whose data lie in a range",
       .wanted = [](const Scene& scene) { return scene.threshold.has_value(); },
       .check = checkClipping,
       .plan = planThreshold},
      {.name = "lighting",
       .description =
           "ambient, diffuse and specular light by the gradient of the scalar; shadows and occlusion imply it",
       .wanted = [](const Scene& scene) { return scene.lighting || scene.shadows || scene.occlusion; },
       .check = checkLighting,
       .light = addLighting,
       .plan = planLighting},
      {.name = "silhouettes",
       .description = "light fades where the gradient is across the ray",
       .wanted = [](const Scene& scene) { return scene.lighting && scene.lighting->silhouettes != 0; },
       .check = checkLighting,
       .light = addSilhouettes,
       .plan = planSilhouettes},
      {.name = "modulation",
       .description = "extinction fades where the scalar hardly changes",
       .wanted = [](const Scene& scene) { return scene.modulation != 0; },
       .check = checkModulation,
       .light = addModulation,
       .plan = planModulation},
      {.name = "ambient occlusion",
       .description = "ambient light is dimmed by what is all around a point",
       .wanted = [](const Scene& scene) { return scene.occlusion.has_value(); },
       .check = checkOcclusion,
       .light = addOcclusion,
       .plan = planOcclusion},
      {.name = "shadows",
       .description = "lights are dimmed by what lies between them and a point",
       .wanted = [](const Scene& scene) { return scene.shadows; },
       .check = checkShadows,
       .light = addShadows,
       .plan = planShadows},
      {.name = "ambient scattering",
       .description = "light that is scattered around a point is added",
       .wanted = [](const Scene& scene) { return scene.scattering.has_value(); },
       .check = checkScattering,
       .light = addScattering,
       .plan = planScattering},
      {.name = "isosurfaces",
       .description = "surfaces of one value of the field, opaque or translucent",
       .wanted = [](const Scene& scene) { return !scene.isosurfaces.empty(); },
       .check = checkIsosurfaceScene,
       .plan = planIsosurfaces},
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
