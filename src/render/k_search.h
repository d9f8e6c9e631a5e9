#pragma once
#include "core/progress.h"
#include "render/plan.h"
#include "scene/prepared_scene.h"
#include "scene/view.h"

namespace havs {

/// Whether the scene asks for a search (`--k auto`) and its visibility method knows a k.
bool wantsKSearch(const Scene& scene);

/// The smallest k with which this view of the scene has no misordered fragment; the largest that the method and the
/// machine take where none is enough: the certificate of the picture drawn with it tells. Scene::k is not looked at.
/// Draws up to four pictures (with early termination up to k) on the current device, which `capabilities` describe; a
/// renderer that ChangesK (render/changes_k.h) builds what it reads once.
/// Throws what plan() and Renderer::draw() throw.
int searchK(const Scene& scene, const PreparedScene& prepared, const View& view, const Capabilities& capabilities,
            const Progress& progress = {});

}  // namespace havs
