#pragma once
#include <functional>
#include <memory>

#include "core/stage_times.h"
#include "scene/prepared_scene.h"
#include "scene/renderer.h"
#include "scene/shown_scalars.h"

namespace havs {

/// Pictures of a mesh without cells: empty, with a certificate of 0 where `certificate` asks for one.
std::unique_ptr<Renderer> rendererOfNothing(bool certificate);

/// What `make` returns for the part of the scene that shows anything of `what` (scene/visible_part.h), which the
/// renderer then owns, or for `prepared` where that is all of it. Where nothing shows, `make` is not called:
/// rendererOfNothing. Stages timed: visible, and those of `make`.
std::unique_ptr<Renderer> rendererOfVisiblePart(
    const PreparedScene& prepared, const WhatShows& what, bool certificate, StageTimes& stages,
    const std::function<std::unique_ptr<Renderer>(const PreparedScene& drawn)>& make);

}  // namespace havs
