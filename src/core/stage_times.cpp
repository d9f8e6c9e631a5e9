#include "core/stage_times.h"

#include <algorithm>
#include <numeric>

#include "core/median.h"

namespace havs {

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

double StageTimes::total(const std::string& stage) const {
  for (const auto& [name, values] : runs_)
    if (name == stage) return std::accumulate(values.begin(), values.end(), 0.0);
  return 0;
}

std::vector<std::pair<std::string, double>> StageTimes::medians() const {
  std::vector<std::pair<std::string, double>> result;
  for (const auto& [name, values] : runs_) result.emplace_back(name, medianOf(values));
  return result;
}

}  // namespace havs
