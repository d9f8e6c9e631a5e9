#include "study/front_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace havs {
using Json = nlohmann::json;
namespace {

constexpr double kMostTicks = 8;

double numberIn(const Json& run, const char* group, const char* key) {
  if (!run.contains(group) || !run[group].is_object()) return std::nan("");
  const Json value = run[group].value(key, Json());
  return value.is_number() ? value.get<double>() : std::nan("");
}

std::string textIn(const Json& object, const char* key) {
  const Json value = object.value(key, Json());
  return value.is_string() ? value.get<std::string>() : "";
}

FrontPoint pointOf(const Json& run) {
  const Json on = run.value("on_front", Json());
  return {numberIn(run, "frame_wall_ms", "median"), numberIn(run, "error", "p999"), textIn(run, "kind"),
          textIn(run, "label"), on.is_boolean() && on.get<bool>()};
}

/// Times of pictures of another size do not compare.
bool isOfSize(const Json& run, const Json& subject) {
  const Json settings = run.value("settings", Json::object());
  return !settings.contains("size") || !subject.contains("size") || settings["size"] == subject["size"];
}

FrontPanel panelOf(const Json& subject, const Json& runs) {
  const std::string field = textIn(subject, "field"), curve = textIn(subject, "transfer_function");
  FrontPanel panel{textIn(subject, "mesh") + (field.empty() ? "" : ", " + field) + (curve.empty() ? "" : ", " + curve),
                   {}};
  for (const Json& run : runs) {
    if (textIn(run, "subject") != textIn(subject, "id") || !isOfSize(run, subject)) continue;
    const FrontPoint point = pointOf(run);
    if (std::isfinite(point.time) && point.time > 0 && std::isfinite(point.error) && point.error >= 0)
      panel.points.push_back(point);
  }
  std::stable_sort(panel.points.begin(), panel.points.end(), [](const FrontPoint& a, const FrontPoint& b) {
    return a.onFront != b.onFront ? b.onFront : a.time < b.time;
  });
  return panel;
}

void addTicks(LogAxis& axis, double from) {
  const double decades = std::log10(axis.most / from);
  static const std::array<std::vector<int>, 4> kDigits{{{1, 2, 3, 4, 5, 6, 7, 8, 9}, {1, 2, 5}, {1, 3}, {1}}};
  const auto fitting = std::find_if(kDigits.begin(), kDigits.end(), [&](const std::vector<int>& digits) {
    return decades * static_cast<double>(digits.size()) <= kMostTicks;
  });
  const std::vector<int>& digits = fitting == kDigits.end() ? kDigits.back() : *fitting;
  const int stride = std::max(1, static_cast<int>(std::ceil(decades / kMostTicks)));
  for (int power = static_cast<int>(std::floor(std::log10(from))); power <= std::log10(axis.most); ++power)
    for (const int digit : digits) {
      const double tick = digit * std::pow(10.0, power);
      if (power % stride == 0 && tick >= from && tick <= axis.most) axis.ticks.push_back(tick);
    }
}

}  // namespace

std::vector<FrontPanel> frontPanels(const Json& study) {
  std::vector<FrontPanel> panels;
  for (const Json& subject : study.at("subjects"))
    if (subject.is_object()) panels.push_back(panelOf(subject, study.at("runs")));
  return panels;
}

double LogAxis::at(double value) const {
  return std::log(std::max(value, value > 0 ? least : zero) / least) / std::log(most / least);
}

LogAxis logAxis(const std::vector<double>& values) {
  LogAxis axis;
  std::vector<double> positive;
  std::copy_if(values.begin(), values.end(), std::back_inserter(positive), [](double value) { return value > 0; });
  const bool hasZero = positive.size() < values.size();
  if (!positive.empty()) {
    const auto [least, most] = std::minmax_element(positive.begin(), positive.end());
    axis.least = *least / 1.3;
    axis.most = *most * 1.3;
  }
  double from = axis.least;
  if (hasZero) {
    axis.zero = std::pow(10.0, std::floor(std::log10(axis.least * 1.3)) - 1);
    axis.least = axis.zero * 0.7;
    from = axis.zero * 3;
    axis.ticks.push_back(0);
  }
  addTicks(axis, from);
  return axis;
}

std::string tickText(double value) {
  if (value >= 0.1 && value < 1e5) return fmt::format("{:.6g}", value);
  if (value == 0) return "0";
  const int power = static_cast<int>(std::floor(std::log10(value) + 1e-9));
  return fmt::format("{:.3g}e{}", value / std::pow(10.0, power), power);
}

}  // namespace havs
