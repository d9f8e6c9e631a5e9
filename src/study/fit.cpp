#include "study/fit.h"

#include <algorithm>
#include <cmath>

namespace havs {
namespace {

constexpr double kAboveFloor = 10;  // the floor then changes a point by a tenth at most, a slope by less than 0.1
constexpr double kWithin = 1.25;    // of the line
constexpr std::size_t kFewest = 3;  // two points lie on a line always

using Points = std::vector<std::array<double, 2>>;

double slopeBetween(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return (std::log(b[1]) - std::log(a[1])) / (std::log(b[0]) - std::log(a[0]));
}

OrderFit fitLine(std::span<const std::array<double, 2>> points) {
  double meanX = 0, meanY = 0, xx = 0, xy = 0, worst = 0;
  const double count = static_cast<double>(points.size());
  for (const auto& [size, error] : points) {
    meanX += std::log(size) / count;
    meanY += std::log(error) / count;
  }
  for (const auto& [size, error] : points) {
    xx += (std::log(size) - meanX) * (std::log(size) - meanX);
    xy += (std::log(size) - meanX) * (std::log(error) - meanY);
  }
  const double slope = xy / xx;
  for (const auto& [size, error] : points)
    worst = std::max(worst, std::abs(std::log(error) - meanY - slope * (std::log(size) - meanX)));
  return {slope, {points.front()[0], points.back()[0]}, std::exp(worst)};
}

/// Without the finest points where the error has stopped to fall.
void dropFlatEnd(Points& points) {
  double steepest = 0;
  for (std::size_t i = 1; i < points.size(); ++i) steepest = std::min(steepest, slopeBetween(points[i - 1], points[i]));
  while (points.size() > 1 && slopeBetween(points[points.size() - 2], points.back()) > 0.5 * steepest)
    points.pop_back();
}

}  // namespace

std::optional<OrderFit> fitOrder(std::span<const std::array<double, 2>> given, double floor) {
  Points points;
  for (const auto& point : given)
    if (point[0] > 0 && point[1] > 0 && std::isfinite(point[1]) && point[1] >= kAboveFloor * floor)
      points.push_back(point);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end(), [](const auto& a, const auto& b) { return a[0] == b[0]; }),
               points.end());
  dropFlatEnd(points);
  for (std::size_t count = points.size(); count >= kFewest; --count)
    for (std::size_t end = points.size(); end >= count; --end) {
      const OrderFit fit = fitLine(std::span(points).subspan(end - count, count));
      if (fit.worstFactor <= kWithin) return fit;
    }
  return std::nullopt;
}

}  // namespace havs
