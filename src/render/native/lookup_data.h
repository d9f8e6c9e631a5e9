#pragma once
// What lookups read besides the segments, as the kernels of the native device see it: plain pointers, as these are
// compiled for other instruction sets than the code that makes it.
#include <cstdint>

namespace havs {

/// A number for the name of a uniform in shaders/ (FNV-1a, 64 bits).
constexpr std::uint64_t nameKey(const char* name) {
  std::uint64_t key = 0xcbf29ce484222325u;
  for (; *name != '\0'; ++name) key = (key ^ static_cast<std::uint64_t>(*name)) * 0x100000001b3u;
  return key;
}

/// Entries that fit into registers, where the instruction set can choose from them.
inline constexpr int kSmallTable = 64;

struct LookupData {
  /// A uniform of the shaders: a table or a number.
  struct Uniform {
    std::uint64_t key = 0;          ///< nameKey of its name
    const float* values = nullptr;  ///< of a table; 4 numbers an entry where it is filtered
    /// Of a table of at most kSmallTable entries of 4 numbers, read by number: these once more, kSmallTable of each
    /// channel in turn; else null.
    const float* channels = nullptr;
    std::int32_t size[3]{};  ///< entries along its axes
    std::int32_t step[3]{};  ///< from an entry to its neighbour along each, in entries; along the last 1
    float number = 0;
  };
  static constexpr int kMostUniforms = 24;
  Uniform uniforms[kMostUniforms];
  int count = 0;
  int lookupNumber = 0;  ///< Lookup::number
  bool cellData = false;
  bool opaqueSurfaces = false;
  bool isosurfaces = false;
  bool lit = false;  ///< segments carry light
};

}  // namespace havs
