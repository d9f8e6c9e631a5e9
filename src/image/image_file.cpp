#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>

#include "core/error.h"
#include "core/memory_budget.h"
#include "core/output_file.h"
#include "image/formats.h"

namespace havs {
namespace fs = std::filesystem;
namespace {

struct ImageFormat {
  std::string extension;
  bool (*write)(const Image&, const fs::path&, const ImageFileOptions&);
  StoredImage (*read)(const fs::path&);
};

const std::array<ImageFormat, 3> kFormats{{
    {".png", writePng, readPng},
    {".exr", writeExr, readExr},
    {".pfm", writePfm, readPfm},
}};

const ImageFormat& formatOf(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const ImageFormat& format : kFormats)
    if (format.extension == extension) return format;
  failInput(extension.empty() ? "an image file needs an extension" : "unknown image format '" + extension + "'",
            file.string(), "use .png, .exr or .pfm");
}

}  // namespace

Image emptyImage(std::int64_t width, std::int64_t height, std::uintmax_t availableBytes, double bytesPerPixel,
                 double compression, const fs::path& file) {
  constexpr std::int64_t kMostPixelsASide = 1 << 20;
  const bool plausible = width > 0 && height > 0 && width <= kMostPixelsASide && height <= kMostPixelsASide &&
                         static_cast<double>(width) * static_cast<double>(height) * bytesPerPixel <=
                             static_cast<double>(availableBytes) * compression;
  if (!plausible)
    failInput(fmt::format("the header promises {} x {} pixels, which the file cannot hold", width, height),
              file.string(), "is it cut off?");
  needMemory(4.0 * sizeof(float) * static_cast<double>(width) * static_cast<double>(height),
             fmt::format("a picture of {} x {} pixels", width, height), file.string());
  Image image;
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  image.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return image;
}

void checkImagePath(const fs::path& file) {
  formatOf(file);
  OutputFile probe(file);
}

void writeImage(const Image& image, const fs::path& file, const ImageFileOptions& options) {
  const ImageFormat& format = formatOf(file);
  if (image.width <= 0 || image.height <= 0) failInput("the picture has no pixels", file.string());
  if (options.pngBits != 8 && options.pngBits != 16)
    failInput(fmt::format("PNG has 8 or 16 bits a channel, not {}", options.pngBits), file.string());
  OutputFile output(file);
  if (!format.write(image, output.temporary(), options)) output.failWriting(errno);
  output.commit();
}

StoredImage readStoredImage(const fs::path& file) {
  const ImageFormat& format = formatOf(file);
  if (!fs::exists(file)) failInput("no such file", file.string());
  if (fs::is_directory(file)) failInput("is a directory, not an image", file.string());
  return format.read(file);
}

Image readImage(const fs::path& file) { return readStoredImage(file).image; }

}  // namespace havs
