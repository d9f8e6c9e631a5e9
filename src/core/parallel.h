#pragma once
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <cstddef>
#include <memory>

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

/// Calls body(first, last) on disjoint blocks of at least `grain` indices that cover [begin, end), from several
/// threads.
template <class Body>
void parallelBlocks(std::size_t begin, std::size_t end, std::size_t grain, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(begin, end, grain),
                    [&](const tbb::blocked_range<std::size_t>& r) { body(r.begin(), r.end()); });
}

/// Calls body(i) for each i of [begin, end), from several threads, in blocks of at least `grain`.
template <class Body>
void parallelFor(std::size_t begin, std::size_t end, std::size_t grain, const Body& body) {
  parallelBlocks(begin, end, grain, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) body(i);
  });
}

}  // namespace havs
