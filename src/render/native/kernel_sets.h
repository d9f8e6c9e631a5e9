#pragma once
#include "render/native/kernels.h"

namespace havs {

/// One for each row of instructionSets(); compiled from kernel_set.cpp.
const KernelSet& scalarKernels();
const KernelSet& sse41Kernels();
const KernelSet& avx2Kernels();
const KernelSet& avx512Kernels();

}  // namespace havs
