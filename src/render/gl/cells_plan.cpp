// What drawing cells takes on OpenGL: one target, two where the order is looked at.
#include <algorithm>

#include "core/error.h"
#include "render/gl/drawing_steps.h"
#include "render/gl/renderers.h"

namespace havs {
namespace {

constexpr int kBytesPerTarget = 16;  // RGBA32F

}  // namespace

void planCells(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities) {
  if (scene.certificate && !capabilities.hasExtension(kFramebufferFetch))
    failRunning("the certificate of cells needs " + std::string(kFramebufferFetch) + ", which this OpenGL lacks", "",
                "draw with --visibility abuffer, whose order is always right");
  plan.bytesPerPixel = scene.certificate ? 2 * kBytesPerTarget : kBytesPerTarget;
  chooseTile(plan, scene, capabilities);
  planCellBuffers(plan, facts);
  addProgram(plan, "colour", "cells.vert", "cells.frag", "each cell's segment is blended as its face comes",
             shaderOptions(plan));
  if (plan.certificate) {
    ShaderOptions options = shaderOptions(plan);
    options.extensions = {kFramebufferFetch};
    addProgram(plan, "certificate", "cells.vert", "cells_certificate.frag", "a certificate is asked for", options);
  }
  const std::size_t pixels = static_cast<std::size_t>(std::min(plan.tileWidth, scene.width)) *
                             static_cast<std::size_t>(std::min(plan.tileHeight, scene.height));
  addItem(plan, PlanKind::target, "colour", "draw", "the picture", kBytesPerTarget, "pixel", pixels);
  addItem(plan, PlanKind::pass, "draw the cells", "draw", "the mode " + plan.mode);
  if (!plan.certificate) return;
  addItem(plan, PlanKind::target, "order seen", "certificate", "a certificate is asked for", kBytesPerTarget, "pixel",
          pixels);
  addItem(plan, PlanKind::pass, "look at the order", "certificate", "a certificate is asked for");
}

}  // namespace havs
