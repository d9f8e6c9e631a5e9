#pragma once
// The image files by format; image_file.cpp chooses among them.
#include <cstdint>
#include <filesystem>

#include "image/image.h"

namespace havs {

/// Each writes to `file` directly (image_file.cpp renames it when whole); false, and errno set, when the disk refuses.
bool writePng(const Image& image, const std::filesystem::path& file, const ImageFileOptions& options);
bool writeExr(const Image& image, const std::filesystem::path& file, const ImageFileOptions& options);
bool writePfm(const Image& image, const std::filesystem::path& file, const ImageFileOptions& options);

/// Each throws Error{input} for a file that is not whole or not of its format.
StoredImage readPng(const std::filesystem::path& file);
StoredImage readExr(const std::filesystem::path& file);
StoredImage readPfm(const std::filesystem::path& file);

/// A picture of this size, zero everywhere. Throws Error{input} (naming `file`) for a size that `availableBytes` of
/// that file cannot hold at `bytesPerPixel` (times `compression`, the most that its packing may shrink): a broken
/// header must not decide how much memory is taken.
Image emptyImage(std::int64_t width, std::int64_t height, std::uintmax_t availableBytes, double bytesPerPixel,
                 double compression, const std::filesystem::path& file);

}  // namespace havs
