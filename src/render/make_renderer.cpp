#include "render/make_renderer.h"

#include <algorithm>

#include "gl/limits.h"
#include "reference/reference_renderer.h"
#include "render/effects.h"
#include "render/eye_cut_renderer.h"
#include "render/overlay_renderer.h"
#include "render/visibility.h"
#include "scene/visible_part_renderer.h"

namespace havs {
namespace {

std::unique_ptr<Renderer> makePartRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                                           const Progress& progress) {
  const auto make = [&](const PreparedScene& drawn) { return plan.way.make(drawn, plan, stages, progress); };
  if (prepared.mesh.tetrahedra.empty()) return rendererOfNothing(plan.certificate);
  return plan.leavesOutCells ? rendererOfVisiblePart(prepared, plan.shows, plan.certificate, stages, make)
                             : make(prepared);
}

}  // namespace

Capabilities capabilitiesOf(const Device& device) {
  const Limits limit = limits();
  Capabilities capabilities;
  capabilities.hasExtension = [&device](const std::string& name) { return device.hasExtension(name); };
  capabilities.maximumDrawBuffers = limit.drawBuffers;
  capabilities.maximumTextureSize = std::min({limit.textureSize, limit.viewportWidth, limit.viewportHeight});
  capabilities.maximum3dTextureSize = limit.texture3dSize;
  capabilities.maximumBufferTexels = static_cast<std::size_t>(limit.bufferTexels);
  capabilities.maximumStorageBlock = static_cast<std::size_t>(limit.storageBlock);
  return capabilities;
}

ViewPoint viewPointOf(const View& view) { return {view.orthographic, view.eye, view.forward}; }

std::unique_ptr<Renderer> makeRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                                       const Progress& progress) {
  auto renderer = rendererForAnyEye(prepared, plan, stages, progress, makePartRenderer);
  return plan.overlays.any() ? rendererWithOverlays(prepared, plan.overlays, std::move(renderer)) : std::move(renderer);
}

namespace {

std::unique_ptr<Renderer> makePlainReference(const Scene& scene, const PreparedScene& prepared) {
  if (const LightPlan light = lightPlanOf(scene); light.lit)
    return makeLitReferenceRenderer(prepared, light, mode(scene.mode).seesVolume);
  return makeReferenceRenderer(prepared, mode(scene.mode).reference);
}

}  // namespace

std::unique_ptr<Renderer> makeReference(const Scene& scene, const PreparedScene& prepared) {
  auto renderer = makePlainReference(scene, prepared);
  return scene.overlays.any() ? rendererWithOverlays(prepared, scene.overlays, std::move(renderer))
                              : std::move(renderer);
}

}  // namespace havs
