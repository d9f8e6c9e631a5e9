#pragma once
// What the rows of visibilityMethods() point to on the native device (DrawingWay, render/visibility.h).
#include <memory>

#include "render/plan.h"
#include "scene/prepared_scene.h"
#include "scene/renderer.h"

namespace havs {

void planNativeKBuffer(RenderPlan& plan, const Scene& scene, const Capabilities& capabilities);
std::unique_ptr<Renderer> makeNativeKBufferRenderer(const PreparedScene& prepared, const RenderPlan& plan,
                                                    StageTimes& stages, const Progress& progress);

}  // namespace havs
