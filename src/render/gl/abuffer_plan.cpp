// What the a-buffer takes on OpenGL: targets, lists, tiles.
#include <algorithm>

#include "render/gl/drawing_steps.h"
#include "render/gl/renderers.h"

namespace havs {
namespace {

constexpr int kBytesPerPixel = 16 + 4 + 4;  // colour and count targets, the end of the list
constexpr std::size_t kBytesPerEnd = 4;
/// Of all lists of a tile. Each tile draws all faces once more.
constexpr std::size_t kMostFragmentBytes = std::size_t{256} << 20;
/// Longer lists are sorted where they lie (abuffer_sort.glsl). A multiple of the runs there (16).
constexpr int kLocalFragments = 256;

}  // namespace

void planABuffer(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities) {
  plan.bytesPerPixel = kBytesPerPixel;
  plan.mostFragments = std::min(kMostFragmentBytes / kBytesPerFragment, capabilities.maximumBufferTexels);
  plan.defines.push_back({"HAVS_LOCAL_FRAGMENTS", std::to_string(kLocalFragments)});
  if (scene.earlyTermination > 0) plan.defines.push_back({"HAVS_EARLY_TERMINATION", "1"});
  chooseTile(plan, scene, capabilities, capabilities.maximumStorageBlock / kBytesPerEnd);
  planFaceBuffers(plan, facts);
  addProgram(plan, "count", "faces.vert", "abuffer_count.frag", "memory is taken for the fragments that there are", {});
  addProgram(plan, "store", "faces.vert", "abuffer_store.frag", "fragments go into the lists of their pixels",
             shaderOptions(plan));
  addProgram(plan, "resolve", "whole_picture.vert", "abuffer_resolve.frag", "lists are sorted and composited",
             shaderOptions(plan));
  const std::size_t pixels = static_cast<std::size_t>(std::min(plan.tileWidth, scene.width)) *
                             static_cast<std::size_t>(std::min(plan.tileHeight, scene.height));
  addItem(plan, PlanKind::target, "colour, counts, ends of lists", "draw", "lists of known length",
          static_cast<std::size_t>(plan.bytesPerPixel), "pixel", pixels);
  addItem(plan, PlanKind::target, "lists of fragments", "draw", "as many as are counted, in tiles of 256 MiB at most",
          kBytesPerFragment, "fragment", 0);
  addItem(plan, PlanKind::pass, "count the fragments", "draw", "the visibility method abuffer keeps them all");
  addItem(plan, PlanKind::pass, "store the fragments", "draw", "the visibility method abuffer keeps them all");
  addItem(plan, PlanKind::pass, "sort and composite the lists", "flush", "the mode " + plan.mode);
}

}  // namespace havs
