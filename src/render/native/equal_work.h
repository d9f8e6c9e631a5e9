#pragma once
// Lookups that take more turns for some segments than for others say how many (workOf, shaders/lookup/exact.glsl). A
// batch of lanes takes as many as its longest segment. So where many would idle, segments of equal work are put
// together; what comes out is the same to the last bit.
#include "render/native/segment_queue.h"
#include "render/native/table_fetch.h"

namespace havs {
namespace {

/// Measured: putting segments in order costs as much as this many turns of all lanes.
constexpr int kTurnsOfSorting = 2;
constexpr std::size_t kSampledBatches = 8;  // one in so many is looked at
constexpr std::int32_t kMostTurns = 127;    // beyond, all are alike

/// What the segments have in the queue.
struct QueuedSegments {
  const float *scalarFront, *scalarBack, *length;
  const float *front, *back;  ///< first channel of the colours, the others at SegmentQueue::kRoom each
  explicit QueuedSegments(const SegmentQueue& queue)
      : scalarFront(queue.scalarFront.data()),
        scalarBack(queue.scalarBack.data()),
        length(queue.length.data()),
        front(queue.front[0].data()),
        back(queue.back[0].data()) {}
};

/// Whether more turns are idle than it costs to avoid them. work(first, turns) writes those of a batch.
template <class Work>
bool manyIdle(std::size_t count, const Work& work) {
  std::int64_t idle = 0, lanes = 0;
  for (std::size_t first = 0; first + Lanes::kLanes <= count; first += kSampledBatches * Lanes::kLanes) {
    std::int32_t turns[Lanes::kLanes], most = 0;
    work(first, turns);
    for (const std::int32_t t : turns) most = t > most ? t : most;
    for (const std::int32_t t : turns) idle += most - t;
    lanes += Lanes::kLanes;
  }
  return idle > kTurnsOfSorting * lanes;
}

/// The segments of a queue by their work, and the way back.
class EqualWork {
 public:
  template <class Work>
  EqualWork(const SegmentQueue& queue, const Work& work) {
    std::int32_t turns[SegmentQueue::kRoom];
    for (std::size_t first = 0; first < queue.count; first += Lanes::kLanes) work(first, turns + first);
    countingSort(turns, queue.count);
    for (std::size_t i = 0; i < queue.count; ++i) {
      scalarFront_[i] = queue.scalarFront[place_[i]];
      scalarBack_[i] = queue.scalarBack[place_[i]];
      length_[i] = queue.length[place_[i]];
    }
    for (std::size_t i = queue.count; i < queue.count + Lanes::kLanes - 1; ++i) {
      place_[i] = static_cast<std::uint16_t>(i);
      scalarFront_[i] = scalarBack_[i] = length_[i] = 0;
    }
  }

  QueuedSegments segments(const SegmentQueue& queue) const {
    QueuedSegments sorted(queue);
    sorted.scalarFront = scalarFront_;
    sorted.scalarBack = scalarBack_;
    sorted.length = length_;
    return sorted;
  }

  /// Puts the colours of the batch from `first` on where its segments stand in the queue.
  void store(float* rgba, std::size_t first, const LaneColor& color) const {
    alignas(64) float rows[4 * Lanes::kLanes];
    storeColor(rows, color);
    for (std::size_t i = 0; i < Lanes::kLanes; ++i)
      *reinterpret_cast<FourAnywhere*>(rgba + 4 * std::size_t{place_[first + i]}) =
          *reinterpret_cast<const FourAnywhere*>(rows + 4 * i);
  }

 private:
  void countingSort(const std::int32_t* turns, std::size_t count) {
    const auto bucket = [&](std::size_t i) { return turns[i] < kMostTurns ? turns[i] : kMostTurns; };
    std::uint16_t begin[kMostTurns + 2]{};
    for (std::size_t i = 0; i < count; ++i) ++begin[bucket(i) + 1];
    for (int t = 0; t < kMostTurns; ++t) begin[t + 1] = static_cast<std::uint16_t>(begin[t + 1] + begin[t]);
    for (std::size_t i = 0; i < count; ++i) place_[begin[bucket(i)]++] = static_cast<std::uint16_t>(i);
  }

  std::uint16_t place_[SegmentQueue::kRoom];
  alignas(64) float scalarFront_[SegmentQueue::kRoom];
  alignas(64) float scalarBack_[SegmentQueue::kRoom];
  alignas(64) float length_[SegmentQueue::kRoom];
};

}  // namespace
}  // namespace havs
