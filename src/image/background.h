#pragma once
#include "image/image.h"

namespace havs {

/// The colour of a premultiplied RGBA pixel over a background: color + (1 - alpha) * background.
inline std::array<float, 3> over(const float* rgba, const Color& background) {
  const double through = 1.0 - static_cast<double>(rgba[3]);
  std::array<float, 3> color;
  for (std::size_t c = 0; c < 3; ++c) color[c] = static_cast<float>(rgba[c] + through * background[c]);
  return color;
}

/// Colour without its alpha, as PNG wants it; a pixel without opacity is black.
inline std::array<float, 4> straight(const float* rgba) {
  if (!(rgba[3] > 0)) return {0, 0, 0, 0};
  return {rgba[0] / rgba[3], rgba[1] / rgba[3], rgba[2] / rgba[3], rgba[3]};
}

}  // namespace havs
