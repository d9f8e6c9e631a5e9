// Portable float map: "PF", width and height, a scale whose sign says the byte order (negative: little endian), then
// rows of RGB floats, the bottom row first.
#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>

#include "core/error.h"
#include "image/background.h"
#include "image/formats.h"

namespace havs {
namespace fs = std::filesystem;
static_assert(std::endian::native == std::endian::little, "PFM rows are written as they lie in memory");

bool writePfm(const Image& image, const fs::path& file, const ImageFileOptions& options) {
  const Background background = options.background.value_or(Color{0, 0, 0});
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream << fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height);
  std::vector<float> row(3 * static_cast<std::size_t>(image.width));
  for (int y = image.height - 1; y >= 0; --y) {
    const Color behind = background.at(y, image.height);
    for (int x = 0; x < image.width; ++x) {
      const auto color = over(image.pixel(x, y), behind);
      std::copy(color.begin(), color.end(), row.begin() + 3 * x);
    }
    stream.write(reinterpret_cast<const char*>(row.data()), static_cast<std::streamsize>(row.size() * sizeof(float)));
  }
  stream.close();
  return stream.good();
}

namespace {
float byteSwapped(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  return std::bit_cast<float>(__builtin_bswap32(bits));
}
}  // namespace

StoredImage readPfm(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string magic;
  std::int64_t width = 0, height = 0;
  double scale = 0;
  stream >> magic >> width >> height >> scale;
  const bool rowStart = stream.get() == '\n';
  if (!stream || !rowStart || magic != "PF" || !(scale != 0))
    failInput("not a colour PFM file", file.string(), "its header must be 'PF', width, height and scale");
  const auto left = fs::file_size(file) - static_cast<std::uintmax_t>(stream.tellg());
  Image image = emptyImage(width, height, left, 3 * sizeof(float), 1, file);
  std::vector<float> row(3 * static_cast<std::size_t>(image.width));
  for (int y = image.height - 1; y >= 0; --y) {
    stream.read(reinterpret_cast<char*>(row.data()), static_cast<std::streamsize>(row.size() * sizeof(float)));
    if (!stream) failInput("the file ends within the pixels", file.string(), "is it cut off?");
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const float value = row[3 * static_cast<std::size_t>(x) + static_cast<std::size_t>(c)];
        image.pixel(x, y)[c] = scale < 0 ? value : byteSwapped(value);
      }
      image.pixel(x, y)[3] = 1;
    }
  }
  return {std::move(image), ImageContent::rgb};
}

}  // namespace havs
