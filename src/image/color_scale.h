#pragma once
#include <vector>

#include "image/axis.h"
#include "image/image.h"

namespace havs {

/// Numbers as colours: those of `colors` at equal steps along the axis, linear in between, the end colours beyond.
struct ColorScale {
  Axis axis;
  std::vector<Color> colors;  ///< at least one; display-referred, 0 to 1
  Color at(double value) const { return atPosition(axis.position(value)); }
  /// 0: the first colour, 1: the last; clamped.
  Color atPosition(double position) const;
};

}  // namespace havs
