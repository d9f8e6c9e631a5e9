#include "image/color_scale.h"

#include <algorithm>

namespace havs {

Color ColorScale::atPosition(double position) const {
  const double place = std::clamp(position, 0.0, 1.0) * static_cast<double>(colors.size() - 1);
  const auto lower = std::min(static_cast<std::size_t>(place), colors.size() - 1);
  const auto upper = std::min(lower + 1, colors.size() - 1);
  const double t = place - static_cast<double>(lower);
  Color color;
  for (std::size_t c = 0; c < 3; ++c) color[c] = (1 - t) * colors[lower][c] + t * colors[upper][c];
  return color;
}

}  // namespace havs
