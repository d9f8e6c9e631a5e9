#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace havs {

/// A float picture: premultiplied RGBA, row 0 on top, display-referred colours as composited, no background.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<float> rgba;  ///< 4 * width * height
  float* pixel(int x, int y) {
    return &rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))];
  }
  const float* pixel(int x, int y) const {
    return &rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))];
  }
};

using Color = std::array<double, 3>;

/// What a picture lies over: one colour, or a gradient from its lower to its upper edge.
struct Background {
  Color bottom{1, 1, 1}, top{1, 1, 1};  ///< of [0, 1]
  Background() = default;
  Background(const Color& color) : bottom(color), top(color) {}
  Background(const Color& low, const Color& high) : bottom(low), top(high) {}
  bool isGradient() const { return bottom != top; }
  /// At the middles of the pixels of a row, row 0 on top: linear in their height.
  Color at(int row, int height) const;
  bool operator==(const Background&) const = default;
};

struct ImageFileOptions {
  std::optional<Background> background = Background{};  ///< none: transparent
  int pngBits = 8;                                      ///< 8 or 16
};

/// Throws Error{input} when writeImage would refuse the name (unknown extension, directory, unwritable): call before
/// long work.
void checkImagePath(const std::filesystem::path& file);

/// By extension, whole or not at all: .png (over the background; straight alpha when there is none), .exr
/// (premultiplied RGBA float, no background), .pfm (RGB float over the background, or over black when there is none).
/// Throws Error.
void writeImage(const Image& image, const std::filesystem::path& file, const ImageFileOptions& options = {});

/// Reads what writeImage writes (premultiplied again). Throws Error{input}.
Image readImage(const std::filesystem::path& file);

/// What the channels of a picture mean.
enum class ImageContent {
  rgba,  ///< premultiplied colour and opacity, without background
  rgb    ///< colour over a background; opacity is 1 in every pixel and says nothing
};

/// A picture with what its file says of it.
struct StoredImage {
  Image image;
  ImageContent content = ImageContent::rgba;  ///< rgba where the file has opacity
  int bits = 32;                              ///< a channel
  bool floats = true;                         ///< else whole numbers, 0 to 1 in 2^bits - 1 steps
};

/// readImage, and what the file says of its content and precision. Throws Error{input}.
StoredImage readStoredImage(const std::filesystem::path& file);

/// "none", a colour as parseColor (image/color_names.h) reads it, or BOTTOM..TOP, two of these. Throws Error{input}.
std::optional<Background> parseBackground(const std::string& text);

}  // namespace havs
