#pragma once
#include <filesystem>
#include <span>
#include <vector>

namespace havs {

/// Throws Error{input} when writeMask would refuse the name (not .png, directory, unwritable): call before long work.
void checkMaskPath(const std::filesystem::path& file);

/// A PNG, white where `mask` is not 0, black elsewhere; whole or not at all. One byte a pixel, row 0 on top. Throws
/// Error.
void writeMask(std::span<const unsigned char> mask, int width, int height, const std::filesystem::path& file);

/// One byte a pixel, row 0 on top, 1 = marked: where the red channel of the image (any format of readImage, opacity
/// not regarded but as a factor of red) is greater than 0.5. Throws Error{input}.
std::vector<unsigned char> readMask(const std::filesystem::path& file, int& width, int& height);

}  // namespace havs
