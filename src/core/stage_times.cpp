#include "core/stage_times.h"

#include <algorithm>

namespace havs {
namespace {
double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}
}  // namespace

void StageTimes::add(const std::string& stage, double milliseconds) {
  auto found = std::find_if(runs_.begin(), runs_.end(), [&](const auto& run) { return run.first == stage; });
  if (found == runs_.end()) found = runs_.insert(runs_.end(), {stage, {}});
  found->second.push_back(milliseconds);
}

double StageTimes::median(const std::string& stage) const {
  for (const auto& [name, values] : runs_)
    if (name == stage) return medianOf(values);
  return 0;
}

std::vector<std::pair<std::string, double>> StageTimes::medians() const {
  std::vector<std::pair<std::string, double>> result;
  for (const auto& [name, values] : runs_) result.emplace_back(name, medianOf(values));
  return result;
}

}  // namespace havs
