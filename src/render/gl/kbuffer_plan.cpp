// What the k-buffer takes on OpenGL: targets, tiles, defines.
#include <algorithm>
#include <cstdint>

#include "core/error.h"
#include "render/gl/drawing_steps.h"
#include "render/gl/renderers.h"
#include "sort/face_order.h"

namespace havs {
namespace {

constexpr std::size_t kMostTilePixels = std::size_t{1} << 25;  // a count of each fits into a storage block of 128 MiB

/// How each payload lies in a fragment and in the k-buffer's targets.
struct PayloadShaders {
  Payload carries;
  const char *payload, *entries;
};
const PayloadShaders& payloadShaders(Payload carries) {
  static constexpr PayloadShaders kRows[] = {{Payload::scalar, "payload.glsl", "entries_scalar.glsl"},
                                             {Payload::color, "payload_color.glsl", "entries_color.glsl"},
                                             {Payload::lit, "payload_lit.glsl", "entries_lit.glsl"}};
  return *std::find_if(std::begin(kRows), std::end(kRows), [&](const auto& row) { return row.carries == carries; });
}

/// What the k-buffer's programs are compiled with.
ShaderOptions kbufferOptions(const RenderPlan& plan) {
  ShaderOptions options = shaderOptions(plan);
  options.standsFor["target_format.glsl"] = plan.targetFormat.shader;
  const PayloadShaders& shaders = payloadShaders(plan.lookup.carries);
  options.standsFor["payload.glsl"] = shaders.payload;
  options.standsFor["entries.glsl"] = shaders.entries;
  return options;
}

void planPrograms(RenderPlan& plan) {
  const ShaderOptions options = kbufferOptions(plan);
  ShaderOptions insert = options;
  if (plan.flagsLate) insert.defines["HAVS_LATE_FLAG"] = "1";
  addProgram(plan, "insert", "faces.vert", "kbuffer.frag", "each fragment goes into its pixel's k-buffer", insert);
  addProgram(plan, "flush", "whole_picture.vert", "kbuffer_flush.frag", "what is left in the k-buffers leaves",
             options);
  if (plan.marksDonePixels)
    addProgram(plan, "done pixels", "whole_picture.vert", "done_pixels.frag",
               "pixels that nothing shows through take no more fragments", options);
}

void planTargets(RenderPlan& plan, const Scene& scene) {
  const std::size_t pixels = static_cast<std::size_t>(std::min(plan.tileWidth, scene.width)) *
                             static_cast<std::size_t>(std::min(plan.tileHeight, scene.height));
  const auto each = static_cast<std::size_t>(plan.targetFormat.bytesPerTarget);
  addItem(plan, PlanKind::target, "colour", "draw", "the picture", each, "pixel", pixels);
  addItem(plan, PlanKind::target, "k-buffer entries", "draw", "k is " + std::to_string(plan.k),
          each * static_cast<std::size_t>(plan.entryTargets), "pixel", pixels);
  if (plan.marksDonePixels)
    addItem(plan, PlanKind::target, "done pixels", "draw", "opaque pixels are spared", 1, "pixel", pixels);
  if (plan.flagsLate)
    addItem(plan, PlanKind::target, "whether any fragment is late", "draw",
            "some cells are left out: a better order might be had", sizeof(std::uint32_t));
  if (plan.certificate)
    addItem(plan, PlanKind::target, "late fragments", "draw", "a certificate is asked for", 4, "pixel", pixels);
}

}  // namespace

void planKBuffer(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities) {
  plan.k = scene.k;
  const int perTarget = entriesPerTarget(plan.lookup.carries);
  plan.entryTargets = (scene.k + perTarget - 1) / perTarget;
  if (1 + plan.entryTargets > capabilities.maximumDrawBuffers)
    failRunning("k = " + std::to_string(scene.k) + " needs " + std::to_string(1 + plan.entryTargets) +
                    " render targets, this OpenGL has " + std::to_string(capabilities.maximumDrawBuffers),
                "", "choose a smaller k");
  plan.targetFormat = targetFormat(scene.targetFormat);
  plan.bytesPerPixel = plan.targetFormat.bytesPerTarget * (1 + plan.entryTargets);
  // Behind an opaque surface nothing is seen. A certificate counts what comes to a pixel, done or not.
  plan.marksDonePixels = !scene.certificate && (scene.earlyTermination > 0 || plan.opaqueSurfaces ||
                                                plan.opaqueIsosurfaces || plan.opaqueLayers);
  if (plan.marksDonePixels) plan.bytesPerPixel += 1;
  plan.defines.push_back({"HAVS_K", std::to_string(plan.k)});
  plan.defines.push_back({"HAVS_ENTRY_TARGETS", std::to_string(plan.entryTargets)});
  if (scene.earlyTermination > 0) plan.defines.push_back({"HAVS_EARLY_TERMINATION", "1"});
  if (sortMethod(plan.sort).isBelieved) plan.defines.push_back({"HAVS_ORDER_BELIEVED", "1"});
  if (scene.compositeLate) plan.defines.push_back({"HAVS_COMPOSITE_LATE", "1"});
  if (plan.marksDonePixels) plan.defines.push_back({"HAVS_MARKS_DONE", "1"});
  if (scene.certificate) plan.defines.push_back({"HAVS_CERTIFICATE", "1"});
  chooseTile(plan, scene, capabilities, kMostTilePixels);
  plan.flagsLate = plan.leavesOutCells && !plan.certificate && sortMethod(plan.sort).usesNeighbours;
  planFaceBuffers(plan, facts);
  planPrograms(plan);
  planTargets(plan, scene);
  addItem(plan, PlanKind::pass, "draw the faces", "draw", "the mode " + plan.mode);
  addItem(plan, PlanKind::pass, "flush the k-buffers", "flush", "entries stay behind the last face");
}

}  // namespace havs
