// Compiled once for each instruction set (CMakeLists.txt): HAVS_KERNELS names the function, HAVS_SIMD_ARCH the lanes.
#include "render/native/kernel_sets.h"
#include "render/native/segment_kernels.h"
#include "render/native/simd.h"

namespace havs {

const KernelSet& HAVS_KERNELS() {
  static const KernelSet set{nullptr, kSegmentKernels};
  return set;
}

}  // namespace havs
