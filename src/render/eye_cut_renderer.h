#pragma once
#include <functional>
#include <memory>

#include "render/plan.h"
#include "scene/prepared_scene.h"
#include "scene/renderer.h"

namespace havs {

/// Makes the renderer of a scene that needs no cut.
using RendererMaker = std::function<std::unique_ptr<Renderer>(const PreparedScene& drawn, const RenderPlan& plan,
                                                              StageTimes& stages, const Progress& progress)>;

/// What `make` returns for `prepared`; for a view that needs it, what it returns for the scene cut before the eye
/// (scene/eye_cut.h). One is kept at a time, and draws again for as long as the cut is the same. A ChangesK
/// (render/changes_k.h). `prepared` must outlive it. Stages timed: those of `make`; while drawing besides eye_cut, for
/// an eye in the mesh's bounding sphere.
std::unique_ptr<Renderer> rendererForAnyEye(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                                            const Progress& progress, RendererMaker make);

}  // namespace havs
