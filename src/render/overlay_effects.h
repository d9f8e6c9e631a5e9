#pragma once
// The rows of effects() for the mesh's outline, boundary surface and wire frame (scene/overlays.h): Effect::check and
// Effect::plan of each.
#include "render/plan.h"
#include "scene/scene.h"

namespace havs {

void checkOutlineScene(const Scene& scene);
void checkSurfaceScene(const Scene& scene);
void checkWireFrameScene(const Scene& scene);

void planOutline(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities);
void planSurface(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities);
void planWireFrame(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities);

}  // namespace havs
