// What modes without an order take on OpenGL.
#include <algorithm>

#include "render/gl/drawing_steps.h"
#include "render/gl/renderers.h"

namespace havs {
namespace {

constexpr int kBytesPerTarget = 16;  // RGBA32F

}  // namespace

void planGathering(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities) {
  const std::string reason = "the mode " + plan.mode;
  plan.bytesPerPixel = kBytesPerTarget;
  chooseTile(plan, scene, capabilities);
  if (plan.gathering == Gathering::sum) {
    planCellBuffers(plan, facts);
    addProgram(plan, "gather", "gather.vert", "gather.frag", reason + " adds up what segments measure",
               shaderOptions(plan));
  } else {
    planFaceBuffers(plan, facts);
    addProgram(plan, "gather", "faces.vert", "extreme.frag", reason + " keeps one scalar of a pixel",
               shaderOptions(plan));
  }
  const std::size_t pixels = static_cast<std::size_t>(std::min(plan.tileWidth, scene.width)) *
                             static_cast<std::size_t>(std::min(plan.tileHeight, scene.height));
  addItem(plan, PlanKind::target, "what is gathered", "draw", reason, kBytesPerTarget, "pixel", pixels);
  addItem(plan, PlanKind::pass, "draw the faces in any order", "draw", reason);
  addItem(plan, PlanKind::pass, "colours from what is gathered", "flush", reason);
}

}  // namespace havs
