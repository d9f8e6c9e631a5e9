#pragma once
// What the static figure of a front shows: points, ranges and ticks, without any drawing.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace havs {

struct FrontPoint {
  double time = 0;   ///< wall milliseconds of a frame, median
  double error = 0;  ///< 99.9th percentile
  std::string kind, label;
  bool onFront = false;
};

struct FrontPanel {
  std::string title;
  std::vector<FrontPoint> points;  ///< runs that were measured, those of the front last and fastest first
};

/// One panel for each subject of a study. Runs that failed, lack a measure or drew a picture of another
/// size are left out.
std::vector<FrontPanel> frontPanels(const nlohmann::json& study);

/// A logarithmic axis.
struct LogAxis {
  double least = 1, most = 10;
  double zero = 0;  ///< where an exact 0 is drawn; 0: there is none
  std::vector<double> ticks;

  /// From 0 at `least` to 1 at `most`; an exact 0 goes to its place.
  double at(double value) const;
};
LogAxis logAxis(const std::vector<double>& values);

/// "1e-4", "20", "0".
std::string tickText(double value);

}  // namespace havs
