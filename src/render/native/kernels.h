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

struct KernelSet {
  /// k from 1 to 14.
  TileKernel (*tileKernel)(int k, Payload carries);
  /// Of the lookup whose shader that is (Lookup::shader).
  SegmentKernel (*segmentKernel)(const std::string& shader);
};

}  // namespace havs
