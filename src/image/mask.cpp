#include "image/mask.h"

#include <algorithm>

#include "core/error.h"
#include "image/image.h"

namespace havs {

void checkMaskPath(const std::filesystem::path& file) {
  checkImagePath(file);
  if (file.extension() != ".png") failInput("a mask is a PNG file", file.string(), "use .png");
}

void writeMask(std::span<const unsigned char> mask, int width, int height, const std::filesystem::path& file) {
  checkMaskPath(file);
  if (width <= 0 || height <= 0 || mask.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    failInput("the mask and its size do not match", file.string());
  Image image;
  image.width = width;
  image.height = height;
  for (const unsigned char marked : mask) {
    const float value = marked != 0 ? 1.0f : 0.0f;
    image.rgba.insert(image.rgba.end(), {value, value, value, 1.0f});
  }
  writeImage(image, file, {Color{0, 0, 0}, 8});
}

std::vector<unsigned char> readMask(const std::filesystem::path& file, int& width, int& height) {
  const Image image = readImage(file);
  width = image.width;
  height = image.height;
  std::vector<unsigned char> mask(image.rgba.size() / 4);
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = image.rgba[4 * i] > 0.5f ? 1 : 0;
  return mask;
}

}  // namespace havs
