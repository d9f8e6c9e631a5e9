#include "study/front.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace havs {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

bool isFinite(const CostError& point) { return std::isfinite(point.cost) && std::isfinite(point.error); }

/// Of `rest` those on its front, ascending in cost.
std::vector<std::size_t> frontOf(std::span<const CostError> all, std::vector<std::size_t> rest) {
  std::stable_sort(rest.begin(), rest.end(), [&](std::size_t a, std::size_t b) {
    return all[a].cost != all[b].cost ? all[a].cost < all[b].cost : all[a].error < all[b].error;
  });
  std::vector<std::size_t> front;
  CostError best{kInfinite, kInfinite};
  for (const std::size_t i : rest) {
    const bool equal = all[i].cost == best.cost && all[i].error == best.error;
    if (!isFinite(all[i]) || (all[i].error >= best.error && !equal)) continue;
    front.push_back(i);
    best = all[i];
  }
  return front;
}

std::vector<std::size_t> allIndices(std::size_t count) {
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

}  // namespace

std::vector<bool> nonDominated(std::span<const CostError> all) {
  std::vector<bool> on(all.size(), false);
  for (const std::size_t i : frontOf(all, allIndices(all.size()))) on[i] = true;
  return on;
}

std::vector<std::size_t> bestOf(std::span<const CostError> all, std::size_t most) {
  std::vector<std::size_t> best, rest = allIndices(all.size());
  while (best.size() < most) {
    std::vector<std::size_t> front = frontOf(all, rest);
    if (front.empty()) break;
    std::erase_if(rest, [&](std::size_t i) { return std::find(front.begin(), front.end(), i) != front.end(); });
    const std::size_t room = most - best.size(), count = std::min(room, front.size());
    for (std::size_t i = 0; i < count; ++i) best.push_back(front[count > 1 ? i * (front.size() - 1) / (count - 1) : 0]);
  }
  return best;
}

}  // namespace havs
