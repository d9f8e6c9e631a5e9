#include "image/mask.h"

#include "core/error.h"
#include "image/image.h"

namespace havs {

std::vector<unsigned char> readMask(const std::filesystem::path& file, int& width, int& height) {
  const Image image = readImage(file);
  width = image.width;
  height = image.height;
  std::vector<unsigned char> mask(image.rgba.size() / 4);
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = image.rgba[4 * i] > 0.5f ? 1 : 0;
  return mask;
}

void writeMask(std::span<const unsigned char> mask, int width, int height, const std::filesystem::path& file) {
  if (width <= 0 || height <= 0 || mask.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    failInput("the mask and its size do not match", file.string());
  Image image{width, height, std::vector<float>(4 * mask.size(), 1.0f)};
  for (std::size_t i = 0; i < mask.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) image.rgba[4 * i + c] = mask[i] ? 1.0f : 0.0f;
  writeImage(image, file);
}

}  // namespace havs
