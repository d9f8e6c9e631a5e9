// Reading PNG through libpng; png_writer.cpp writes it.
#include <png.h>

#include <bit>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <memory>

#include "core/error.h"
#include "image/background.h"
#include "image/file_pointer.h"
#include "image/formats.h"

namespace havs {
namespace fs = std::filesystem;
namespace {

/// Where libpng's errors go: kept as text, then back to the caller's setjmp.
struct PngMessages {
  std::string error = "unknown reason";
};
void onError(png_structp png, png_const_charp message) {
  static_cast<PngMessages*>(png_get_error_ptr(png))->error = message;
  png_longjmp(png, 1);
}
void onWarning(png_structp, png_const_charp) {}

struct Reader {
  PngMessages messages;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &messages, onError, onWarning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  bool hasOpacity = false;
  int bits = 8;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

/// No memory is taken for rows yet.
bool readHeader(Reader& reader, std::FILE* file) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_init_io(reader.png, file);
  png_set_user_limits(reader.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_read_info(reader.png, reader.info);
  reader.bits = png_get_bit_depth(reader.png, reader.info) == 16 ? 16 : 8;
  reader.hasOpacity = (png_get_color_type(reader.png, reader.info) & PNG_COLOR_MASK_ALPHA) != 0 ||
                      png_get_valid(reader.png, reader.info, PNG_INFO_tRNS) != 0;
  return true;
}

bool readRows(Reader& reader, Image& image, std::vector<std::uint16_t>& row) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  // RGBA, 16 bits a channel in the machine's byte order.
  png_set_expand_16(reader.png);
  png_set_gray_to_rgb(reader.png);
  png_set_add_alpha(reader.png, 0xffff, PNG_FILLER_AFTER);
  if constexpr (std::endian::native == std::endian::little) png_set_swap(reader.png);
  png_read_update_info(reader.png, reader.info);
  for (int y = 0; y < image.height; ++y) {
    png_read_row(reader.png, reinterpret_cast<png_bytep>(row.data()), nullptr);
    for (int x = 0; x < image.width; ++x) {
      const std::uint16_t* from = row.data() + 4 * static_cast<std::size_t>(x);
      float* to = image.pixel(x, y);
      to[3] = static_cast<float>(from[3] / 65535.0);
      for (int c = 0; c < 3; ++c) to[c] = static_cast<float>(from[c] / 65535.0 * (from[3] / 65535.0));
    }
  }
  png_read_end(reader.png, nullptr);
  return true;
}

}  // namespace

StoredImage readPng(const fs::path& file) {
  FilePointer stream(std::fopen(file.c_str(), "rb"));
  if (!stream) failInput("cannot be read", file.string());
  Reader reader;
  if (!reader.info) throw std::bad_alloc();
  if (!readHeader(reader, stream.get())) failInput("not a PNG file: " + reader.messages.error, file.string());
  if (png_get_interlace_type(reader.png, reader.info) != PNG_INTERLACE_NONE)
    failInput("interlaced PNG files are not read", file.string(), "save it without interlacing");
  constexpr double kMostThatZipShrinks = 1100;  // deflate packs 1032 bytes into one at best
  constexpr double kLeastBytesPerPixel = 1.0 / 8;
  Image image = emptyImage(png_get_image_width(reader.png, reader.info), png_get_image_height(reader.png, reader.info),
                           fs::file_size(file), kLeastBytesPerPixel, kMostThatZipShrinks, file);
  std::vector<std::uint16_t> row(4 * static_cast<std::size_t>(image.width));
  if (!readRows(reader, image, row))
    failInput("broken PNG file: " + reader.messages.error, file.string(), "is it cut off?");
  return {std::move(image), reader.hasOpacity ? ImageContent::rgba : ImageContent::rgb, reader.bits, false};
}

}  // namespace havs
