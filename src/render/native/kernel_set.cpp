// Compiled once for each instruction set (CMakeLists.txt): HAVS_KERNELS names the function, HAVS_SIMD_ARCH the lanes.
#include "render/native/gather_kernel.h"
#include "render/native/kernel_sets.h"
#include "render/native/segment_kernels.h"
#include "render/native/simd.h"
#include "render/native/tile_kernel.h"

namespace havs {
namespace {

template <int kAttributes, int K = 1>
TileKernel kernelOf(int k) {
  if constexpr (K > kLargestK) {
    return nullptr;
  } else {
    return k == K ? drawTileKernel<SimdLanes, EntriesOfPixels<SimdLanes, K, kAttributes>, kAttributes>
                  : kernelOf<kAttributes, K + 1>(k);
  }
}

TileKernel tileKernel(int k, Payload carries) { return carries == Payload::color ? kernelOf<4>(k) : kernelOf<1>(k); }

TileKernel orderedTileKernel(Payload carries) {
  return carries == Payload::color ? drawTileKernel<SimdLanes, LastOfPixels<SimdLanes, 4>, 4>
                                   : drawTileKernel<SimdLanes, LastOfPixels<SimdLanes, 1>, 1>;
}

TileKernel extremeKernel(bool greatest) {
  return greatest ? gatherTile<ExtremeGatherer<SimdLanes, true>> : gatherTile<ExtremeGatherer<SimdLanes, false>>;
}

}  // namespace

const KernelSet& HAVS_KERNELS() {
  static const KernelSet set{tileKernel, orderedTileKernel, gatherTile<SegmentGatherer<SimdLanes>>, extremeKernel,
                             kSegmentKernels};
  return set;
}

}  // namespace havs
