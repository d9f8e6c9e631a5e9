#pragma once
// The kernels of an instruction set (HAVS_INSTRUCTIONS): one for each file of shaders/lookup and shaders/measure. CMake
// writes the list.
#include "render/native/kernels.h"

#define HAVS_JOIN_NAMES(a, b) a##_##b
#define HAVS_JOIN(a, b) HAVS_JOIN_NAMES(a, b)
/// avx2_table_3d, for example.
#define HAVS_SEGMENT_KERNEL(lookup) HAVS_JOIN(HAVS_INSTRUCTIONS, lookup)

namespace havs {

#define HAVS_LOOKUP(folder, name) void HAVS_SEGMENT_KERNEL(name)(const LookupData& data, SegmentQueue& queue);
#include "lookup_list.inc"
#undef HAVS_LOOKUP

/// By the path of the lookup's shader; ends with a null name.
static constexpr NamedSegmentKernel kSegmentKernels[] = {
#define HAVS_LOOKUP(folder, name) {#folder "/" #name ".glsl", HAVS_SEGMENT_KERNEL(name)},
#include "lookup_list.inc"
#undef HAVS_LOOKUP
    {nullptr, nullptr}};

}  // namespace havs
