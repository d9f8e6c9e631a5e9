#include "image/comparable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"

namespace havs {
namespace {

/// Whether opacity is `value` in every pixel.
bool opacityIs(const Image& image, float value) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] != value) return false;
  return true;
}

bool hasEmptyPixel(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] == 0) return true;
  return false;
}

bool opaque(const NamedPicture& picture) {
  return picture.stored.content == ImageContent::rgb || opacityIs(picture.stored.image, 1);
}

void refuseOpaqueAgainst(const NamedPicture& opaquePicture, const NamedPicture& other) {
  if (opaquePicture.stored.content == ImageContent::rgb)
    failInput(fmt::format("holds colours over a background, but {} holds opacity", other.name), opaquePicture.name,
              "write both as .exr, or both as .pfm or .png over one --background");
  if (hasEmptyPixel(other.stored.image))
    failInput(
        fmt::format("is opaque in every pixel, but {} has empty ones: it seems to lie over a background", other.name),
        opaquePicture.name, "write both without a background");
}

/// The colour of all pixels at the picture's border, where it is one to within a step of 8 bits.
std::optional<Color> borderColor(const Image& image) {
  const float* corner = image.pixel(0, 0);
  const auto same = [&](int x, int y) {
    for (int c = 0; c < 3; ++c)
      if (std::abs(image.pixel(x, y)[c] - corner[c]) > 1.0f / 255) return false;
    return true;
  };
  for (int x = 0; x < image.width; ++x)
    if (!same(x, 0) || !same(x, image.height - 1)) return std::nullopt;
  for (int y = 0; y < image.height; ++y)
    if (!same(0, y) || !same(image.width - 1, y)) return std::nullopt;
  return Color{corner[0], corner[1], corner[2]};
}

double greatestDifference(const Color& a, const Color& b) {
  double greatest = 0;
  for (std::size_t c = 0; c < 3; ++c) greatest = std::max(greatest, std::abs(a[c] - b[c]));
  return greatest;
}

std::string textOf(const Color& color) { return fmt::format("{:.3g},{:.3g},{:.3g}", color[0], color[1], color[2]); }

void noteRounding(const NamedPicture& picture, std::vector<std::string>& notes) {
  const auto& stored = picture.stored;
  if (!stored.floats)
    notes.push_back(
        fmt::format("{} has {} bits a channel: values beyond 0 to 1 are cut, and errors below {:.1e} cannot "
                    "be told from its rounding; .exr and .pfm keep all digits",
                    picture.name, stored.bits, 0.5 / (std::exp2(stored.bits) - 1)));
  else if (stored.bits < 32)
    notes.push_back(fmt::format("{} has {}-bit floats: values are rounded by up to 1/4096 of themselves", picture.name,
                                stored.bits));
}

}  // namespace

ImageContent commonContent(const NamedPicture& a, const NamedPicture& b) {
  const bool opaqueA = opaque(a), opaqueB = opaque(b);
  if (opaqueA && opaqueB) {
    const bool bothKeepOpacity = a.stored.content == ImageContent::rgba && b.stored.content == ImageContent::rgba;
    return bothKeepOpacity ? ImageContent::rgba : ImageContent::rgb;
  }
  if (opaqueA) refuseOpaqueAgainst(a, b);
  if (opaqueB) refuseOpaqueAgainst(b, a);
  return ImageContent::rgba;
}

std::vector<std::string> comparisonNotes(const NamedPicture& a, const NamedPicture& b) {
  std::vector<std::string> notes;
  noteRounding(a, notes);
  noteRounding(b, notes);
  const auto borderA = borderColor(a.stored.image), borderB = borderColor(b.stored.image);
  if (opaque(a) && opaque(b) && borderA && borderB && greatestDifference(*borderA, *borderB) > 2.0 / 255)
    notes.push_back(fmt::format("the border of {} is {}, that of {} is {}: do they lie over different backgrounds?",
                                a.name, textOf(*borderA), b.name, textOf(*borderB)));
  return notes;
}

}  // namespace havs
