#include "study/page_pictures.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>

namespace havs {
namespace fs = std::filesystem;
using Json = nlohmann::json;
namespace {

constexpr int kMostReduction = 8;

std::set<std::string> namesOfPictures(const Json& study) {
  std::set<std::string> names;
  const auto add = [&](const Json& holder, const char* key) {
    if (holder.is_object() && holder.contains(key) && holder[key].is_string()) names.insert(holder[key]);
  };
  for (const Json& subject : study.value("subjects", Json::array()))
    if (subject.is_object() && subject.contains("reference")) add(subject["reference"], "image");
  for (const char* list : {"runs", "effects"})
    for (const Json& run : study.value(list, Json::array()))
      for (const char* key : {"image", "difference", "reference"}) add(run, key);
  return names;
}

bool staysInside(const fs::path& name) {
  return name.is_relative() && std::find(name.begin(), name.end(), fs::path("..")) == name.end();
}

std::optional<std::string> readPngBytes(const fs::path& file) {
  static const std::string kSignature = "\x89PNG\r\n\x1a\n";
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream || !bytes.starts_with(kSignature)) return std::nullopt;
  return bytes;
}

struct Pixels {
  png_uint_32 width = 0, height = 0;
  std::vector<png_byte> rgba;
};

std::optional<Pixels> decode(const std::string& png) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&image, png.data(), png.size())) return std::nullopt;
  image.format = PNG_FORMAT_RGBA;
  Pixels pixels{image.width, image.height, std::vector<png_byte>(PNG_IMAGE_SIZE(image))};
  if (!png_image_finish_read(&image, nullptr, pixels.rgba.data(), 0, nullptr)) return std::nullopt;
  return pixels;
}

std::string encode(const Pixels& pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = pixels.width;
  image.height = pixels.height;
  image.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.rgba.data(), 0, nullptr)) return {};
  bytes.resize(size);
  return bytes;
}

/// The mean of the pixels of one block, which ends at the picture's edge.
std::array<png_byte, 4> meanOfBlock(const Pixels& from, png_uint_32 left, png_uint_32 top, png_uint_32 side) {
  std::array<std::uint64_t, 4> sum{};
  const png_uint_32 right = std::min(left + side, from.width), bottom = std::min(top + side, from.height);
  for (png_uint_32 y = top; y < bottom; ++y)
    for (png_uint_32 x = left; x < right; ++x) {
      const png_byte* pixel = &from.rgba[4 * (std::size_t{y} * from.width + x)];
      for (std::size_t c = 0; c < 3; ++c) sum[c] += std::uint64_t{pixel[c]} * pixel[3];
      sum[3] += pixel[3];
    }
  const std::uint64_t count = std::uint64_t{right - left} * (bottom - top),
                      opacity = std::max<std::uint64_t>(sum[3], 1);
  const auto rounded = [](std::uint64_t a, std::uint64_t b) { return static_cast<png_byte>((a + b / 2) / b); };
  return {rounded(sum[0], opacity), rounded(sum[1], opacity), rounded(sum[2], opacity), rounded(sum[3], count)};
}

}  // namespace

std::string reducedPng(const std::string& png, int factor) {
  const std::optional<Pixels> from = decode(png);
  if (!from || factor <= 1) return png;
  const auto side = static_cast<png_uint_32>(factor);
  Pixels to{(from->width + side - 1) / side, (from->height + side - 1) / side, {}};
  to.rgba.reserve(4 * std::size_t{to.width} * to.height);
  for (png_uint_32 y = 0; y < to.height; ++y)
    for (png_uint_32 x = 0; x < to.width; ++x) {
      const auto pixel = meanOfBlock(*from, x * side, y * side, side);
      to.rgba.insert(to.rgba.end(), pixel.begin(), pixel.end());
    }
  std::string reduced = encode(to);
  return reduced.empty() ? png : reduced;
}

PagePictures readPagePictures(const Json& study, const fs::path& folder, std::uintmax_t mostBytes) {
  PagePictures pictures;
  for (const std::string& name : namesOfPictures(study)) {
    std::optional<std::string> bytes = staysInside(name) ? readPngBytes(folder / name) : std::nullopt;
    if (!bytes) {
      pictures.missing.push_back(name);
      continue;
    }
    pictures.bytes += bytes->size();
    pictures.png.emplace(name, std::move(*bytes));
  }
  const auto area = [&] {
    return static_cast<std::uintmax_t>(pictures.reduction) * static_cast<std::uintmax_t>(pictures.reduction);
  };
  while (pictures.bytes / area() > mostBytes && pictures.reduction < kMostReduction) ++pictures.reduction;
  if (pictures.reduction == 1) return pictures;
  pictures.bytes = 0;
  for (auto& [name, bytes] : pictures.png) {
    bytes = reducedPng(bytes, pictures.reduction);
    pictures.bytes += bytes.size();
  }
  return pictures;
}

std::string base64(const std::string& bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  const auto byteAt = [&](std::size_t i) { return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u; };
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const unsigned group = byteAt(i) << 16 | byteAt(i + 1) << 8 | byteAt(i + 2);
    text += kDigits[group >> 18];
    text += kDigits[group >> 12 & 63];
    text += i + 1 < bytes.size() ? kDigits[group >> 6 & 63] : '=';
    text += i + 2 < bytes.size() ? kDigits[group & 63] : '=';
  }
  return text;
}

}  // namespace havs
