// A part of the mesh: what preparing the scene has to do for it (scene/clip_scene.h).
#include "render/effect_parts.h"

namespace havs {

void planClipping(RenderPlan& plan, const Scene& scene, const SceneFacts&, const Capabilities&) {
  const std::size_t count = scene.clipPlanes.size() + scene.clipBoxes.size();
  addItem(plan, PlanKind::precomputation, "cells cut at planes and boxes", "prepare",
          "the scene has " + std::to_string(count) + (count == 1 ? " of them" : " of them, of which all count"));
}

void planThreshold(RenderPlan& plan, const Scene&, const SceneFacts&, const Capabilities&) {
  addItem(plan, PlanKind::precomputation, "the cells within the threshold", "prepare", "the scene has one");
}

}  // namespace havs
