#pragma once
// The table of number formats of render targets (docs/06-add-a-method.md).
#include <span>
#include <string>
#include <vector>

namespace havs {

/// One row of the table (`--target-format`).
struct TargetFormat {
  std::string name;
  std::string description;
  std::string shader;       ///< file below shaders/ that packs numbers into texels
  int bytesPerTarget = 0;   ///< four channels
  bool halfFloats = false;  ///< 16 bits a channel, stored as integers; else 32-bit floats
};
std::span<const TargetFormat> targetFormats();
/// Throws Error{input}, naming the nearest.
const TargetFormat& targetFormat(const std::string& name);

}  // namespace havs
