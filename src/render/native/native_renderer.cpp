#include "core/error.h"
#include "render/native/renderers.h"

namespace havs {

void planNativeKBuffer(RenderPlan& plan, const Scene& scene, const Capabilities&) { plan.k = scene.k; }

std::unique_ptr<Renderer> makeNativeKBufferRenderer(const PreparedScene&, const RenderPlan&, StageTimes&,
                                                    const Progress&) {
  failRunning("the native device is being built", "--device native", "draw with --device osmesa");
}

}  // namespace havs
