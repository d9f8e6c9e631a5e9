#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "transfer/transfer_function.h"

namespace havs {

using RgbColor = std::array<double, 3>;

/// How ParaView's colour maps go from one colour to the next. `step`: the second colour all the way. `diverging`:
/// Moreland, Diverging Color Maps for Scientific Visualization (ISVC 2009): in polar CIELAB (magnitude, saturation,
/// hue), through white between two distinct hues.
enum class ColorSpace { rgb, hsv, hsvNoWrap, lab, diverging, step };

/// The space ParaView calls `name` (letters' case free); nothing where it is not known.
std::optional<ColorSpace> colorSpaceNamed(const std::string& name);

/// The colour the fraction t, 0 to 1, of the way from a to b, clamped to [0, 1]. Colours are sRGB.
RgbColor interpolateColor(ColorSpace space, const RgbColor& a, const RgbColor& b, double t);

/// Colours, ascending in scalar, joined in `space`, as points joined linearly in RGB to within 1/1024. Opacities are
/// not used.
std::vector<ControlPoint> resampleToRgb(ColorSpace space, const std::vector<ControlPoint>& colors);

}  // namespace havs
