#pragma once
#include <filesystem>
#include <span>
#include <vector>

namespace havs {

/// A mask of pixels from a picture (.png, .exr, .pfm): one byte a pixel, 1 where its red channel is above 0.5, row 0 on
/// top. Throws Error{input} as readImage.
std::vector<unsigned char> readMask(const std::filesystem::path& file, int& width, int& height);

/// Writes a mask as a picture that readMask reads: white where it is not 0, else black. Throws Error{input} for a mask
/// that has not width * height bytes, Error as writeImage.
void writeMask(std::span<const unsigned char> mask, int width, int height, const std::filesystem::path& file);

}  // namespace havs
