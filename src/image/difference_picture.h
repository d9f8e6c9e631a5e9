#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "image/color_scale.h"
#include "image/image.h"

namespace havs {

/// How the error of a picture is shown.
struct DifferenceStyle {
  std::vector<Color> colors;           ///< of the scale, no error first; must be even to the eye (inferno, viridis)
  bool logarithmic = true;             ///< from 1e-7, or a thousandth of the top where that is less
  std::optional<double> max;           ///< error at the top; default the greatest of the picture, where it is not 0: 1
  std::optional<std::size_t> channel;  ///< 0 to 3; default the worst of `channels`
  std::size_t channels = 4;            ///< 3 for pictures without opacity
  Color masked{0.5, 0.5, 0.5};         ///< of pixels left out
};

/// A difference picture and what it shows.
struct DifferencePicture {
  Image image;
  ColorScale scale;
};

/// The error of each pixel of `picture` against `truth` as a colour, pixel (x, y) of the result for pixel (x, y), and
/// to its right the colour bar with the greatest error and the number of pixels left out. Opaque, on white; a low
/// picture is given white rows below, so that the bar can be read. `mask` as for compareImages. Throws Error{input} for
/// pictures or a mask that differ in size, no colours, a `max` that is not positive and finite.
DifferencePicture differencePicture(const Image& picture, const Image& truth, std::span<const unsigned char> mask,
                                    const DifferenceStyle& style);

}  // namespace havs
