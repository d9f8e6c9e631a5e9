#pragma once
#include <memory>

#include "scene/overlays.h"
#include "scene/prepared_scene.h"
#include "scene/renderer.h"

namespace havs {

/// What `renderer` draws of `prepared`, which must outlive it, with the overlays: surface and wire frame are its layers
/// (overlay/boundary_layers.h), the outline lies over and under its picture (overlay/outline.h). A ChangesK
/// (render/changes_k.h) for a renderer that is one. Stages timed besides: layers, outline.
std::unique_ptr<Renderer> rendererWithOverlays(const PreparedScene& prepared, const Overlays& overlays,
                                               std::unique_ptr<Renderer> renderer);

}  // namespace havs
