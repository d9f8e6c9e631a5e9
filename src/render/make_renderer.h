#pragma once
#include <memory>

#include "gl/device.h"
#include "render/plan.h"
#include "scene/prepared_scene.h"
#include "scene/renderer.h"
#include "sort/face_order.h"

namespace havs {

/// What plans need to know of the current OpenGL.
Capabilities capabilitiesOf(const Device& device);

/// Where the faces are sorted from.
ViewPoint viewPointOf(const View& view);

/// The renderer of a plan. It draws only the cells that show anything (scene/visible_part.h), and for an eye in the
/// mesh only what is before it (scene/eye_cut.h). `prepared` and the current device must outlive it. Stages timed:
/// visible, table, upload_mesh; while drawing besides those of rendererWithOverlays.
std::unique_ptr<Renderer> makeRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                                       const Progress& progress = {});

/// The ground truth of a scene, which must outlive it as `prepared` must: the same picture, in double.
std::unique_ptr<Renderer> makeReference(const Scene& scene, const PreparedScene& prepared);

}  // namespace havs
