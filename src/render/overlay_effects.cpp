#include "render/overlay_effects.h"

#include "core/error.h"

namespace havs {
namespace {

/// What lies at many depths of the volume.
void checkLayers(const Scene& scene, const char* option, const char* what) {
  if (const Mode& shown = mode(scene.mode); shown.gathering != Gathering::composite)
    failInput("the mode " + shown.name + " composites nothing, so it shows no " + what, option,
              "leave it out, or draw with --mode volume or isosurfaces");
  if (const VisibilityMethod& method = visibilityMethod(scene.visibility); !method.takesLayers)
    failInput("the visibility method " + method.name + " draws no " + what, option,
              "leave it out, or draw with --visibility kbuffer or abuffer");
}

/// Once for surface and wire frame together.
void planLayers(RenderPlan& plan, const std::string& what) {
  addItem(plan, PlanKind::precomputation, "layers of the " + what, "layers", "the scene asks for the " + what);
  if (plan.layers) return;
  plan.layers = true;
  plan.defines.push_back({"HAVS_LAYERS", "1"});
}

}  // namespace

void checkOutlineScene(const Scene& scene) { checkOutline(*scene.overlays.outline); }

void checkSurfaceScene(const Scene& scene) {
  checkSurface(*scene.overlays.surface);
  checkLayers(scene, "--surface", "boundary surface");
}

void checkWireFrameScene(const Scene& scene) {
  checkWireFrame(*scene.overlays.wireFrame);
  checkLayers(scene, "--wireframe", "wire frame");
}

void planOutline(RenderPlan& plan, const Scene& scene, const SceneFacts&, const Capabilities&) {
  plan.overlays.outline = scene.overlays.outline;
  addItem(plan, PlanKind::pass, "outline, over and under the picture", "outline", "the scene asks for an outline");
}

void planSurface(RenderPlan& plan, const Scene& scene, const SceneFacts&, const Capabilities&) {
  plan.overlays.surface = scene.overlays.surface;
  plan.opaqueLayers = scene.overlays.surface->opacity >= 1;
  planLayers(plan, "boundary surface");
}

void planWireFrame(RenderPlan& plan, const Scene& scene, const SceneFacts&, const Capabilities&) {
  plan.overlays.wireFrame = scene.overlays.wireFrame;
  planLayers(plan, "wire frame");
}

}  // namespace havs
