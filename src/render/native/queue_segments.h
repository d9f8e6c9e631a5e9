#pragma once
// From SIMD lanes into the queue of segments. Included by the tile kernels.
#include <bit>

#include "render/native/face_raster.h"

namespace havs {
namespace {

/// Those of the lanes of `bits`; `firstPixel`: number in the tile of the pixel of lane 0. Flushes a full queue.
template <class Lanes, int kAttributes, class Segment>
void queueSegment(TileDraw& tile, const Segment& segment, unsigned bits, int firstPixel) {
  SegmentQueue& queue = *tile.queue;
  const auto mask = Lanes::maskOf(bits);
  const std::size_t at = queue.count;
  if constexpr (kAttributes == 1) {
    Lanes::compress(&queue.scalarFront[at], segment.scalarFront, mask, bits);
    Lanes::compress(&queue.scalarBack[at], segment.scalarBack, mask, bits);
  } else {
    for (int i = 0; i < 4; ++i) {
      Lanes::compress(&queue.front[i][at], segment.front.color[i], mask, bits);
      Lanes::compress(&queue.back[i][at], segment.back.color[i], mask, bits);
    }
  }
  Lanes::compress(&queue.length[at], segment.length, mask, bits);
  Lanes::compressInts(&queue.pixel[at], Lanes::makeInt(firstPixel) + Lanes::loadInts(kLaneNumber), mask, bits);
  queue.count = at + static_cast<std::size_t>(std::popcount(bits));
  if (queue.count + kStampPixels > SegmentQueue::kCapacity || tile.flushAlways) tile.flush(tile);
}

}  // namespace
}  // namespace havs
