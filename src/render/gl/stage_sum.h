#pragma once
#include <chrono>
#include <string>
#include <utility>

#include "core/stage_times.h"

namespace havs {

/// Adds up the wall time of the parts of a stage, tile after tile, and hands over the sum when it goes.
class StageSum {
 public:
  StageSum(StageTimes& stages, std::string name) : stages_(stages), name_(std::move(name)) {}
  ~StageSum() { stages_.add(name_, sum_); }
  StageSum(const StageSum&) = delete;
  StageSum& operator=(const StageSum&) = delete;

  template <class Work>
  void time(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    sum_ += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  }

 private:
  StageTimes& stages_;
  std::string name_;
  double sum_ = 0;
};

}  // namespace havs
