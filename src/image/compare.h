#pragma once
#include <array>
#include <cstddef>
#include <span>

#include "image/image.h"

namespace havs {

/// How far a picture is from another, in the unit of their channels (0 to 1).
struct ErrorMeasures {
  double rmse = 0;  ///< root of the mean square over pixels (and channels)
  double p999 = 0;  ///< error that 99.9% of the pixels stay at or below; a pixel's error is that of its worst channel
  double max = 0;   ///< of the worst pixel
  double psnr = 0;  ///< 20 log10(1 / rmse), dB; infinite for equal pictures
  double ssim = 1;  ///< mean structural similarity (Wang et al. 2004: Gaussian window of 11, sigma 1.5, range 1)
};

/// Two pictures compared.
struct Comparison {
  ErrorMeasures rgba;                     ///< all four channels together
  std::array<ErrorMeasures, 4> channels;  ///< red, green, blue, opacity
  std::size_t pixels = 0;                 ///< compared
  std::size_t masked = 0;                 ///< left out
  int worstX = 0, worstY = 0;             ///< pixel of rgba.max
};

/// Measures `picture` against `truth`, in premultiplied linear float RGBA, row 0 on top. `mask`: one byte a pixel, those
/// not 0 are left out (of SSIM: as centres of windows, and their values are taken from `truth` in both pictures); empty:
/// none. Throws Error{input} for pictures of different size, empty ones, a mask of another size or one that leaves
/// nothing, values that are not finite.
Comparison compareImages(const Image& picture, const Image& truth, std::span<const unsigned char> mask = {});

}  // namespace havs
