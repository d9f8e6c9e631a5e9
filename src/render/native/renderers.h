#pragma once
// What the rows of visibilityMethods() and modes() point to on the native device (DrawingWay, render/visibility.h).
#include <memory>

#include "render/plan.h"
#include "scene/prepared_scene.h"
#include "scene/renderer.h"

namespace havs {

void planNativeKBuffer(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities);
void planNativeGathering(RenderPlan& plan, const Scene& scene, const SceneFacts& facts,
                         const Capabilities& capabilities);
/// Draws either.
std::unique_ptr<Renderer> makeNativeRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                                             const Progress& progress);

}  // namespace havs
