#pragma once
#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace havs {

/// Wall milliseconds of named stages, in the order in which they first ran. A stage may run many times.
class StageTimes {
 public:
  void add(const std::string& stage, double milliseconds);
  /// Median over the runs of the stage; 0 for a stage that never ran.
  double median(const std::string& stage) const;
  /// Sum over the runs of the stage.
  double total(const std::string& stage) const;
  /// Stage names and their medians.
  std::vector<std::pair<std::string, double>> medians() const;

 private:
  std::vector<std::pair<std::string, std::vector<double>>> runs_;
};

/// Times the scope it lives in.
class ScopedStage {
 public:
  ScopedStage(StageTimes& times, std::string stage)
      : times_(times), stage_(std::move(stage)), start_(std::chrono::steady_clock::now()) {}
  ~ScopedStage() {
    times_.add(stage_, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count());
  }
  ScopedStage(const ScopedStage&) = delete;
  ScopedStage& operator=(const ScopedStage&) = delete;

 private:
  StageTimes& times_;
  std::string stage_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace havs
