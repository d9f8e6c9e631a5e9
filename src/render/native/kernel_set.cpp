// Compiled once for each instruction set (CMakeLists.txt): HAVS_KERNELS names the function, HAVS_SIMD_ARCH the lanes.
#include "render/native/gather_kernel.h"
#include "render/native/kernel_sets.h"
#include "render/native/segment_kernels.h"
#include "render/native/simd.h"
#include "render/native/tile_kernel.h"

namespace havs {
namespace {

template <template <class> class PayloadOf, int K = 1>
TileKernel kernelOf(int k) {
  if constexpr (K > kLargestK) {
    return nullptr;
  } else {
    return k == K ? drawTileKernel<SimdLanes, EntriesOfPixels<SimdLanes, K, PayloadOf>> : kernelOf<PayloadOf, K + 1>(k);
  }
}

TileKernel tileKernel(int k, Payload carries) {
  switch (carries) {
    case Payload::color:
      return kernelOf<ColorPayload>(k);
    case Payload::lit:
      return kernelOf<LitPayload>(k);
    default:
      return kernelOf<ScalarPayload>(k);
  }
}

TileKernel orderedTileKernel(Payload carries) {
  switch (carries) {
    case Payload::color:
      return drawTileKernel<SimdLanes, LastOfPixels<SimdLanes, ColorPayload>>;
    case Payload::lit:
      return drawTileKernel<SimdLanes, LastOfPixels<SimdLanes, LitPayload>>;
    default:
      return drawTileKernel<SimdLanes, LastOfPixels<SimdLanes, ScalarPayload>>;
  }
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
