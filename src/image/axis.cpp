#include "image/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace havs {
namespace {

/// Ticks this near beyond an end, in parts of the axis, still belong to it.
constexpr double kSlack = 1e-9;

bool onAxis(const Axis& axis, double value) {
  const double position = axis.position(value);
  return position >= -kSlack && position <= 1 + kSlack;
}

Tick tickAt(const Axis& axis, double value, std::string label) {
  return {value, std::clamp(axis.position(value), 0.0, 1.0), std::move(label)};
}

/// The least of 1, 2, 5 times a power of ten that gives at most `most` ticks.
double linearStep(double range, int most) {
  const double least = range / (most - 1);
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least * (1 - kSlack)) return factor * power;
  return 10 * power;
}

std::vector<Tick> linearTicks(const Axis& axis, int most) {
  const double step = linearStep(axis.high - axis.low, most);
  std::vector<Tick> ticks;
  for (double i = std::ceil(axis.low / step - kSlack); onAxis(axis, i * step); ++i)
    ticks.push_back(tickAt(axis, i * step, numberLabel(i * step, 6)));
  return ticks;
}

std::string superscript(int number) {
  static const std::array<const char*, 10> kDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(number))) text += kDigits[static_cast<std::size_t>(digit - '0')];
  return text;
}

std::string powerLabel(int exponent) { return exponent == 0 ? "1" : "10" + superscript(exponent); }

std::vector<Tick> decadeTicks(const Axis& axis, int most) {
  const int first = static_cast<int>(std::ceil(std::log10(axis.low) - kSlack));
  const int last = static_cast<int>(std::floor(std::log10(axis.high) + kSlack));
  const int stride = 1 + (last - first) / most;
  std::vector<Tick> ticks;
  for (int decade = first - 1; decade <= last; ++decade)
    for (int digit = 1; digit <= (stride == 1 ? 9 : 1); ++digit) {
      const double value = digit * std::pow(10.0, decade);
      const bool labelled = digit == 1 && decade % stride == 0;
      if (onAxis(axis, value)) ticks.push_back(tickAt(axis, value, labelled ? powerLabel(decade) : ""));
    }
  return ticks;
}

std::string withoutTrailingZeros(std::string number) {
  if (number.find('.') == std::string::npos) return number;
  number.erase(number.find_last_not_of('0') + 1);
  if (number.back() == '.') number.pop_back();
  return number;
}

}  // namespace

double Axis::position(double value) const {
  if (!logarithmic) return (value - low) / (high - low);
  if (!(value > 0)) return -std::numeric_limits<double>::infinity();
  return std::log(value / low) / std::log(high / low);
}

void requireAxis(const Axis& axis) {
  if (!std::isfinite(axis.low) || !std::isfinite(axis.high) || !(axis.low < axis.high))
    failInput(fmt::format("no scale goes from {} to {}", axis.low, axis.high));
  if (axis.logarithmic && !(axis.low > 0))
    failInput(fmt::format("a logarithmic scale cannot begin at {}", axis.low), "", "begin above 0");
}

std::vector<Tick> ticksOf(const Axis& axis, int most) {
  requireAxis(axis);
  const bool overDecades = axis.logarithmic && axis.high / axis.low >= 10;
  return overDecades ? decadeTicks(axis, most) : linearTicks(axis, most);
}

std::string numberLabel(double value, int digits) {
  if (value == 0) return "0";
  const double magnitude = std::abs(value);
  if (magnitude >= 1e-3 && magnitude < 1e5) {
    const int decimals = std::max(0, digits - 1 - static_cast<int>(std::floor(std::log10(magnitude))));
    return withoutTrailingZeros(fmt::format("{:.{}f}", value, decimals));
  }
  const std::string scientific = fmt::format("{:.{}e}", value, digits - 1);
  const std::size_t e = scientific.find('e');
  const std::string mantissa = withoutTrailingZeros(scientific.substr(0, e));
  const std::string power = powerLabel(std::stoi(scientific.substr(e + 1)));
  return mantissa == "1" ? power : mantissa + "×" + power;
}

}  // namespace havs
