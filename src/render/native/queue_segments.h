#pragma once
// From SIMD lanes into the queue of segments. Included by the tile kernels.
#include <bit>

#include "render/native/face_raster.h"

namespace havs {
namespace {

/// Those of the lanes of `bits`; `firstPixel`: number in the tile of the pixel of lane 0. Flushes a full queue.
template <class Lanes, class Segment>
void queueSegment(TileDraw& tile, Segment segment, unsigned bits, int firstPixel) {
  SegmentQueue& queue = *tile.queue;
  const auto mask = Lanes::maskOf(bits);
  const std::size_t at = queue.count;
  constexpr bool kScalars = requires { segment.front.scalar; }
  || !requires { segment.front; };
  if constexpr (kScalars) {
    Lanes::compress(&queue.scalarFront[at], segment.scalarFront, mask, bits);
    Lanes::compress(&queue.scalarBack[at], segment.scalarBack, mask, bits);
  }
  if constexpr (requires { segment.front; }) {
    constexpr int kFirst = kScalars ? 1 : 0;  // the scalar is not there twice
    for (int i = kFirst; i < decltype(segment.front)::kNumbers; ++i) {
      const auto channel = static_cast<std::size_t>(i - kFirst);
      Lanes::compress(&queue.front[channel][at], segment.front.number(i), mask, bits);
      Lanes::compress(&queue.back[channel][at], segment.back.number(i), mask, bits);
    }
  }
  if constexpr (requires { segment.middle; }) {
    if (tile.layers != nullptr) Lanes::compress(&queue.middle[at], segment.middle, mask, bits);
  }
  Lanes::compress(&queue.length[at], segment.length, mask, bits);
  Lanes::compressInts(&queue.pixel[at], Lanes::makeInt(firstPixel) + Lanes::loadInts(kLaneNumber), mask, bits);
  queue.count = at + static_cast<std::size_t>(std::popcount(bits));
  if (queue.count + kStampPixels > SegmentQueue::kCapacity || tile.flushAlways) tile.flush(tile);
}

}  // namespace
}  // namespace havs
