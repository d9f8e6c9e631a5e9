#pragma once
#include <span>
#include <vector>

namespace havs {

/// What a setting costs and how wrong it is; less is better in both.
struct CostError {
  double cost = 0;
  double error = 0;
};

/// Which of them no other dominates: none is at most as expensive and at most as wrong, and better in one of the two.
/// Equal ones are all kept. Values that are not finite never belong to the front.
std::vector<bool> nonDominated(std::span<const CostError> all);

/// The indices of the best `most`: the front first, then the front of the rest, and so on; of the last one taken evenly
/// along the cost. Ascending in cost within each front.
std::vector<std::size_t> bestOf(std::span<const CostError> all, std::size_t most);

}  // namespace havs
