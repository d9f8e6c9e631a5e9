#include "core/parallel.h"

namespace havs {

std::size_t threadCount() { return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism); }

ThreadLimit::ThreadLimit(std::size_t threads) {
  if (threads > 0)
    control_ = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, threads);
}

}  // namespace havs
