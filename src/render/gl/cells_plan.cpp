// What drawing cells takes on OpenGL: one target, two where the order is looked at.
#include "core/error.h"
#include "render/gl/renderers.h"

namespace havs {
namespace {

constexpr int kBytesPerTarget = 16;  // RGBA32F

}  // namespace

void planCells(RenderPlan& plan, const Scene& scene, const Capabilities& capabilities) {
  if (scene.certificate && !capabilities.hasExtension(kFramebufferFetch))
    failRunning("the certificate of cells needs " + std::string(kFramebufferFetch) + ", which this OpenGL lacks", "",
                "draw with --visibility abuffer, whose order is always right");
  plan.bytesPerPixel = scene.certificate ? 2 * kBytesPerTarget : kBytesPerTarget;
  chooseTile(plan, scene, capabilities);
}

}  // namespace havs
