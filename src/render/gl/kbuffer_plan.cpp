// What the k-buffer takes on OpenGL: targets, tiles, defines.
#include "core/error.h"
#include "render/gl/renderers.h"

namespace havs {
namespace {

constexpr std::size_t kMostTilePixels = std::size_t{1} << 25;  // a count of each fits into a storage block of 128 MiB

}  // namespace
void planKBuffer(RenderPlan& plan, const Scene& scene, const Capabilities& capabilities) {
  plan.k = scene.k;
  const int perTarget = entriesPerTarget(plan.lookup);
  plan.entryTargets = (scene.k + perTarget - 1) / perTarget;
  if (1 + plan.entryTargets > capabilities.maximumDrawBuffers)
    failRunning("k = " + std::to_string(scene.k) + " needs " + std::to_string(1 + plan.entryTargets) +
                    " render targets, this OpenGL has " + std::to_string(capabilities.maximumDrawBuffers),
                "", "choose a smaller k");
  plan.targetFormat = targetFormat(scene.targetFormat);
  plan.bytesPerPixel = plan.targetFormat.bytesPerTarget * (1 + plan.entryTargets);
  // Behind an opaque surface nothing is seen. A certificate counts what comes to a pixel, done or not.
  plan.marksDonePixels = !scene.certificate && (scene.earlyTermination > 0 || plan.opaqueSurfaces);
  if (plan.marksDonePixels) plan.bytesPerPixel += 1;
  plan.defines.push_back({"HAVS_K", std::to_string(plan.k)});
  plan.defines.push_back({"HAVS_ENTRY_TARGETS", std::to_string(plan.entryTargets)});
  if (scene.earlyTermination > 0) plan.defines.push_back({"HAVS_EARLY_TERMINATION", "1"});
  if (scene.compositeLate) plan.defines.push_back({"HAVS_COMPOSITE_LATE", "1"});
  if (plan.marksDonePixels) plan.defines.push_back({"HAVS_MARKS_DONE", "1"});
  if (scene.certificate) plan.defines.push_back({"HAVS_CERTIFICATE", "1"});
  chooseTile(plan, scene, capabilities, kMostTilePixels);
}

}  // namespace havs
