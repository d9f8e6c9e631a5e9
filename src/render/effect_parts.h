#pragma once
// What the rows of effects() are made of: one file a group.
#include "render/effects.h"

namespace havs {

// Surfaces of one value (effects_isosurfaces.cpp).
void checkIsosurfaceScene(const Scene& scene);
void planIsosurfaces(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities);

// Light (effects_light.cpp). Each check refuses modes, methods and lookups whose fragments cannot be lit, too.
void checkLighting(const Scene& scene);
void checkModulation(const Scene& scene);
void checkOcclusion(const Scene& scene);
void checkShadows(const Scene& scene);
void checkScattering(const Scene& scene);
void addLighting(LightPlan& light, const Scene& scene);
void addSilhouettes(LightPlan& light, const Scene& scene);
void addModulation(LightPlan& light, const Scene& scene);
void addOcclusion(LightPlan& light, const Scene& scene);
void addShadows(LightPlan& light, const Scene& scene);
void addScattering(LightPlan& light, const Scene& scene);
void planLighting(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities);
void planSilhouettes(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities);
void planModulation(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities);
void planOcclusion(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities);
void planShadows(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities);
void planScattering(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities);
/// Of the lights that a scene places, whether any effect is lit by them or not: their number, intensities, directions.
void checkLights(const Scene& scene);

// A part of the mesh (effects_part.cpp).
void planClipping(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities);
void planThreshold(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities);

}  // namespace havs
