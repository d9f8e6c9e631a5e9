#pragma once
// What is compiled for each instruction set.
#include <string>

#include "render/lookups.h"

namespace havs {

struct TileDraw;
struct SegmentQueue;
struct LookupData;

/// Draws a tile's faces into its k-buffer (render/native/tile_kernel.h).
using TileKernel = void (*)(TileDraw& tile);
/// Writes the colours of a queue's segments (render/native/segment_shader.h).
using SegmentKernel = void (*)(const LookupData& data, SegmentQueue& queue);

struct NamedSegmentKernel {
  const char* shader;  ///< Lookup::shader of its lookup
  SegmentKernel kernel;
};

struct KernelSet {
  /// k from 1 to 14.
  TileKernel (*tileKernel)(int k, Payload carries);
  /// Of every lookup; ends with a null shader.
  const NamedSegmentKernel* segmentKernels;
};

}  // namespace havs
