// Compiled once for each instruction set (CMakeLists.txt): HAVS_KERNELS names the function, HAVS_SIMD_ARCH the lanes.
#include "render/native/kernel_sets.h"
#include "render/native/segment_kernels.h"
#include "render/native/simd.h"
#include "render/native/tile_kernel.h"

namespace havs {
namespace {

template <int kAttributes, bool kSpeculative, int K = 1>
TileKernel kernelOf(int k) {
  if constexpr (K > (kSpeculative ? 2 : kLargestK)) {
    return nullptr;
  } else {
    return k == K ? drawTileKernel<SimdLanes, K, kAttributes, kSpeculative>
                  : kernelOf<kAttributes, kSpeculative, K + 1>(k);
  }
}

TileKernel tileKernel(int k, Payload carries) {
  return carries == Payload::color ? kernelOf<4, false>(k) : kernelOf<1, false>(k);
}

TileKernel speculativeTileKernel(int k, Payload carries) {
  return carries == Payload::color ? kernelOf<4, true>(k) : kernelOf<1, true>(k);
}

}  // namespace

const KernelSet& HAVS_KERNELS() {
  static const KernelSet set{tileKernel, speculativeTileKernel, kSegmentKernels};
  return set;
}

}  // namespace havs
