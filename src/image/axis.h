#pragma once
#include <string>
#include <vector>

namespace havs {

/// A scale from `low` to `high`, linear or logarithmic. low < high, both finite, low > 0 where logarithmic.
struct Axis {
  double low = 0;
  double high = 1;
  bool logarithmic = false;
  /// 0 at `low`, 1 at `high`, not clamped; -infinity for values <= 0 on a logarithmic axis.
  double position(double value) const;
};

/// Throws Error{input} for an axis that is none.
void requireAxis(const Axis& axis);

struct Tick {
  double value = 0;
  double position = 0;  ///< 0 to 1
  std::string label;    ///< empty: a minor tick
};

/// Where an axis is marked, ascending, at most `most` (at least 2) of them labelled: linear, at steps of 1, 2 or 5
/// times a power of ten; logarithmic, at powers of ten (each, or every second, third ...) with minor ticks at 2 to 9
/// between neighbouring ones; an axis of less than a decade at linear steps.
std::vector<Tick> ticksOf(const Axis& axis, int most = 8);

/// A number as it stands at a tick or in a caption, with `digits` significant digits at most: 0.002, 1500, 2×10⁻⁶,
/// 10⁻⁷.
std::string numberLabel(double value, int digits = 3);

}  // namespace havs
