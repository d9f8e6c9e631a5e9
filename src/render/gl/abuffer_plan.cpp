// What the a-buffer takes on OpenGL: targets, lists, tiles.
#include <algorithm>

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

void planABuffer(RenderPlan& plan, const Scene& scene, const Capabilities& capabilities) {
  plan.bytesPerPixel = kBytesPerPixel;
  plan.mostFragments = std::min(kMostFragmentBytes / kBytesPerFragment, capabilities.maximumBufferTexels);
  plan.defines.push_back({"HAVS_LOCAL_FRAGMENTS", std::to_string(kLocalFragments)});
  if (scene.earlyTermination > 0) plan.defines.push_back({"HAVS_EARLY_TERMINATION", "1"});
  chooseTile(plan, scene, capabilities, capabilities.maximumStorageBlock / kBytesPerEnd);
}

}  // namespace havs
