// OpenEXR through tinyexr: premultiplied RGBA, 32-bit float, ZIP. In the file channels stand in alphabetical order.
#include <tinyexr.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>

#include "core/error.h"
#include "core/isolated.h"
#include "core/memory_budget.h"
#include "image/formats.h"

namespace havs {
namespace fs = std::filesystem;
namespace {

constexpr int kChannels = 4;
constexpr std::array<const char*, kChannels> kNames{"A", "B", "G", "R"};
constexpr std::array<std::size_t, kChannels> kPlaceInRgba{3, 2, 1, 0};

struct ParsedHeader {
  EXRHeader header;
  ParsedHeader() { InitEXRHeader(&header); }
  ~ParsedHeader() { FreeEXRHeader(&header); }
};

/// tinyexr frees a picture that it could not load itself, but its channels only as far as `num_channels` says.
struct LoadedImage {
  EXRImage image;
  bool whole = false;
  explicit LoadedImage(const EXRHeader& header) {
    InitEXRImage(&image);
    image.num_channels = header.num_channels;
  }
  ~LoadedImage() {
    if (whole) FreeEXRImage(&image);
  }
};

std::string messageOf(const char* error) {
  std::string text = error ? error : "unknown reason";
  if (error) FreeEXRErrorMessage(error);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::array<std::vector<float>, kChannels> planesOf(const Image& image) {
  std::array<std::vector<float>, kChannels> planes;
  const std::size_t pixels = image.rgba.size() / kChannels;
  for (std::size_t c = 0; c < kChannels; ++c) {
    planes[c].resize(pixels);
    for (std::size_t i = 0; i < pixels; ++i) planes[c][i] = image.rgba[kChannels * i + kPlaceInRgba[c]];
  }
  return planes;
}

}  // namespace

bool writeExr(const Image& image, const fs::path& file, const ImageFileOptions&) {
  auto planes = planesOf(image);
  std::array<unsigned char*, kChannels> pointers;
  std::array<EXRChannelInfo, kChannels> channels{};
  std::array<int, kChannels> types;
  for (std::size_t c = 0; c < kChannels; ++c) {
    pointers[c] = reinterpret_cast<unsigned char*>(planes[c].data());
    std::strncpy(channels[c].name, kNames[c], sizeof channels[c].name - 1);
    types[c] = TINYEXR_PIXELTYPE_FLOAT;
  }
  EXRImage exr;
  InitEXRImage(&exr);
  exr.images = pointers.data();
  exr.num_channels = kChannels;
  exr.width = image.width;
  exr.height = image.height;
  EXRHeader header;
  InitEXRHeader(&header);
  header.num_channels = kChannels;
  header.channels = channels.data();
  header.pixel_types = types.data();
  header.requested_pixel_types = types.data();
  header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
  const char* error = nullptr;
  unsigned char* memory = nullptr;
  const std::size_t size = SaveEXRImageToMemory(&exr, &header, &memory, &error);
  const std::unique_ptr<unsigned char, decltype(&std::free)> owner(memory, std::free);
  if (size == 0) failRunning("packing the image failed: " + messageOf(error), file.string());
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream.write(reinterpret_cast<const char*>(memory), static_cast<std::streamsize>(size));
  stream.close();
  return stream.good();
}

namespace {

std::vector<unsigned char> bytesOf(const fs::path& file) {
  needMemory(static_cast<double>(fs::file_size(file)), "the file", file.string());
  std::vector<unsigned char> bytes(fs::file_size(file));
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!stream) failInput("cannot be read", file.string());
  return bytes;
}

/// Of the colours: the file may hold other channels of another type.
int bitsOf(const EXRHeader& header, int channel) {
  return header.channels[channel].pixel_type == TINYEXR_PIXELTYPE_HALF ? 16 : 32;
}

/// Number of the channel in the file; -1 when the file has none of that name.
int channelNamed(const EXRHeader& header, const char* name) {
  for (int c = 0; c < header.num_channels; ++c)
    if (std::strcmp(header.channels[c].name, name) == 0) return c;
  return -1;
}

bool isWhole(const EXRHeader& header, int channel) {
  return header.channels[channel].pixel_type == TINYEXR_PIXELTYPE_UINT;
}

/// Whole numbers (an object's number, say) come as such or not at all: tinyexr aborts when they are asked for as
/// floats.
int typeToAskFor(const EXRHeader& header, int channel) {
  return isWhole(header, channel) ? TINYEXR_PIXELTYPE_UINT : TINYEXR_PIXELTYPE_FLOAT;
}

/// Red, green and blue are there, and with opacity, where it is, in floats.
void checkChannels(const EXRHeader& header, const fs::path& file) {
  for (const char* name : kNames) {
    const int channel = channelNamed(header, name);
    const bool optional = name == kNames[0];
    if (channel < 0 && !optional) failInput(std::string("no channel ") + name, file.string());
    if (channel >= 0 && isWhole(header, channel))
      failInput(std::string("the channel ") + name + " holds whole numbers", file.string(), "write half or float");
  }
}

/// tinyexr asserts what a broken file does not hold: it is not to end the program.
StoredImage readHere(const fs::path& file) {
  const auto bytes = bytesOf(file);
  EXRVersion version;
  if (ParseEXRVersionFromMemory(&version, bytes.data(), bytes.size()) != TINYEXR_SUCCESS)
    failInput("not an OpenEXR file", file.string());
  if (version.multipart || version.non_image || version.tiled)
    failInput("only OpenEXR files of one part in scan lines are read", file.string());
  ParsedHeader parsed;
  EXRHeader& header = parsed.header;
  const char* error = nullptr;
  if (ParseEXRHeaderFromMemory(&header, &version, bytes.data(), bytes.size(), &error) != TINYEXR_SUCCESS)
    failInput("broken OpenEXR header: " + messageOf(error), file.string());
  checkChannels(header, file);
  constexpr double kMostThatZipShrinks = 1100;  // deflate packs 1032 bytes into one at best
  const std::int64_t width = std::int64_t{header.data_window.max_x} - header.data_window.min_x + 1;
  const std::int64_t height = std::int64_t{header.data_window.max_y} - header.data_window.min_y + 1;
  Image image = emptyImage(width, height, bytes.size(), 2.0 * header.num_channels, kMostThatZipShrinks, file);
  for (int c = 0; c < header.num_channels; ++c) header.requested_pixel_types[c] = typeToAskFor(header, c);
  LoadedImage loaded(header);
  loaded.whole = LoadEXRImageFromMemory(&loaded.image, &header, bytes.data(), bytes.size(), &error) == TINYEXR_SUCCESS;
  if (!loaded.whole) failInput("broken OpenEXR pixels: " + messageOf(error), file.string(), "is it cut off?");
  const std::size_t pixels = image.rgba.size() / kChannels;
  for (std::size_t c = 0; c < kChannels; ++c) {
    const int channel = channelNamed(header, kNames[c]);
    const auto* plane = channel < 0 ? nullptr : reinterpret_cast<const float*>(loaded.image.images[channel]);
    for (std::size_t i = 0; i < pixels; ++i) image.rgba[kChannels * i + kPlaceInRgba[c]] = plane ? plane[i] : 1.0f;
  }
  const bool hasOpacity = channelNamed(header, "A") >= 0;
  return {std::move(image), hasOpacity ? ImageContent::rgba : ImageContent::rgb,
          bitsOf(header, channelNamed(header, "G"))};
}

}  // namespace

StoredImage readExr(const fs::path& file) {
  IsolatedRun run = runIsolated([&](ByteWriter& reply) {
    const StoredImage read = readHere(file);
    reply.put(std::array{read.image.width, read.image.height, read.bits});
    reply.put(read.content);
    reply.put(read.image.rgba);
  });
  if (!run.death.empty())
    failInput("broken OpenEXR file: tinyexr breaks down on it (" + run.death + ")", file.string(), "is it cut off?");
  StoredImage stored;
  const auto [width, height, bits] = run.reply.get<std::array<int, 3>>();
  stored.content = run.reply.get<ImageContent>();
  stored.image = {width, height, run.reply.getVector<float>()};
  stored.bits = bits;
  return stored;
}

}  // namespace havs
