#pragma once
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_group.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

#include "core/happens_before.h"

namespace havs {

/// Threads that parallel loops use now.
std::size_t threadCount();

/// While it lives, parallel loops use at most `threads` threads; 0 leaves the number of cores.
class ThreadLimit {
 public:
  explicit ThreadLimit(std::size_t threads);

 private:
  std::unique_ptr<tbb::global_control> control_;
};

/// A grain for loops that do a few sums for each of their indices.
inline constexpr std::size_t kGrain = 8192;

/// Calls body(first, last) on disjoint blocks of at least `grain` indices that cover [begin, end), from several
/// threads.
template <class Body>
void parallelBlocks(std::size_t begin, std::size_t end, std::size_t grain, const Body& body) {
  LoopOrder order;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(begin, end, grain), [&](const tbb::blocked_range<std::size_t>& r) {
    const LoopOrder::Block block(order);
    body(r.begin(), r.end());
  });
}

/// Calls body(i) for each i of [begin, end), from several threads, in blocks of at least `grain`.
template <class Body>
void parallelFor(std::size_t begin, std::size_t end, std::size_t grain, const Body& body) {
  parallelBlocks(begin, end, grain, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) body(i);
  });
}

/// join over the values that body(first, last) returns for disjoint blocks of [begin, end). How the range is cut
/// depends on the threads, so join(a, b) must be exact: a minimum or a maximum, not a sum of floating-point numbers.
template <class Value, class Body, class Join>
Value parallelReduce(std::size_t begin, std::size_t end, std::size_t grain, const Value& identity, const Body& body,
                     const Join& join) {
  LoopOrder order;
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(begin, end, grain), identity,
      [&](const tbb::blocked_range<std::size_t>& r, const Value& value) {
        const LoopOrder::Block block(order);
        return join(value, body(r.begin(), r.end()));
      },
      join);
}

/// Work that other threads do beside the one that adds it.
class Tasks {
 public:
  /// body(number) will be called for each number added, from several threads, in any order.
  explicit Tasks(std::function<void(std::size_t)> body) : body_(std::move(body)) {}
  /// Drops what has not begun, unless wait() has been called.
  ~Tasks() {
    group_.cancel();
    try {
      wait();
    } catch (...) {  // it has been thrown by wait() before, or something else is on its way
    }
  }
  Tasks(const Tasks&) = delete;
  Tasks& operator=(const Tasks&) = delete;

  /// What the body needs for `number` must be there.
  void add(std::size_t number) {
    order_.started();
    group_.run([this, number] {
      const LoopOrder::Block block(order_);
      body_(number);
    });
  }
  /// Returns when all that was added is done; rethrows what a body threw.
  void wait() {
    group_.wait();
    order_.finished();
  }

 private:
  std::function<void(std::size_t)> body_;
  LoopOrder order_;
  tbb::task_group group_;
};

}  // namespace havs
