#pragma once
// What is compiled for each instruction set.
#include <string>

#include "render/lookups.h"

namespace havs {

struct TileDraw;
struct SegmentQueue;
struct LookupData;

/// Draws a tile's faces through its k-buffer, the flush at the end included (render/native/tile_draw.h).
using TileKernel = void (*)(TileDraw& tile);
/// Writes the colours of a queue's segments (render/native/segment_shader.h).
using SegmentKernel = void (*)(const LookupData& data, SegmentQueue& queue);

struct NamedSegmentKernel {
  const char* shader;  ///< Lookup::shader of its lookup
  SegmentKernel kernel;
};

struct KernelSet {
  /// k from 1 to kLargestK.
  TileKernel (*tileKernel)(int k, Payload carries);
  /// For fragments that come in order: keeps the last one of a pixel, and flags the pixel where one comes nearer than
  /// that. All other pixels are, to the last bit, what every k gives.
  TileKernel (*orderedTileKernel)(Payload carries);
  /// For segments that come in any order (render/native/gather_kernel.h).
  TileKernel segmentsOfCells;
  /// For the greatest or the least scalar of a pixel.
  TileKernel (*extremeKernel)(bool greatest);
  /// Of every lookup and measure; ends with a null shader.
  const NamedSegmentKernel* segmentKernels;
};

}  // namespace havs
