#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string>

#include "image/image.h"

namespace havs {

/// How far a picture is from another, in the unit of their channels (0 to 1).
struct ErrorMeasures {
  double rmse = 0;  ///< root of the mean square over pixels (and channels)
  double p999 = 0;  ///< the ceil(0.999 n)-th smallest of the n pixels' errors (nearest rank): 99.9% stay at or below
                    ///< it. A pixel's error is that of its worst channel. Of fewer than 1000 pixels it is the maximum
  double max = 0;   ///< of the worst pixel
  double psnr = 0;  ///< 20 log10(1 / rmse), dB; infinite for equal pictures
  double ssim = 1;  ///< mean structural similarity (image/ssim.h), of several channels their mean; not a number where
                    ///< the mask leaves no centre of a window
};

/// Two pictures compared.
struct Comparison {
  ImageContent content = ImageContent::rgba;
  std::size_t channelCount = 4;           ///< 3 for rgb, whose opacity says nothing
  ErrorMeasures rgba;                     ///< the channels together (of rgb content: three)
  std::array<ErrorMeasures, 4> channels;  ///< red, green, blue, opacity; the first channelCount are set
  std::size_t pixels = 0;                 ///< compared
  std::size_t masked = 0;                 ///< left out
  int worstX = 0, worstY = 0;             ///< pixel of rgba.max, the first in reading order
  std::size_t worstChannel = 0;           ///< channel of rgba.max
};
inline constexpr std::array<const char*, 4> kChannelNames{"red", "green", "blue", "opacity"};

/// Measures `picture` against `truth`, in premultiplied linear float, row 0 on top. `mask`: one byte a pixel, those not
/// 0 are left out (of SSIM: as centres of windows, and their values are taken from `truth` in both pictures); empty:
/// none. The same to the last bit for any number of threads. Throws Error{input} for pictures of different size, empty
/// ones, a mask of another size or one that leaves nothing, values that are not finite.
Comparison compareImages(const Image& picture, const Image& truth, std::span<const unsigned char> mask = {},
                         ImageContent content = ImageContent::rgba);

/// Throws Error{input}, with the place of the first, for a value that is no finite number. `name`: of the picture, for
/// the message.
void requireFinite(const Image& image, const std::string& name);

/// Throws Error{input} for pictures that differ in size or are empty, and a mask (unless empty) of another size.
void requireSameSize(const Image& picture, const Image& truth, std::span<const unsigned char> mask = {});

}  // namespace havs
