#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace havs {

/// Segments that wait for their colours, as structure of arrays: what shaders/core/kbuffer.glsl calls a Segment. All
/// are visible.
struct SegmentQueue {
  static constexpr std::size_t kCapacity = 1024;
  static constexpr std::size_t kRoom = kCapacity + 32;  ///< kernels read and write whole lanes, and compressed stores
  std::size_t count = 0;
  alignas(64) std::array<float, kRoom> scalarFront;
  alignas(64) std::array<float, kRoom> scalarBack;
  alignas(64) std::array<float, kRoom> length;  ///< local units, >= 0
  alignas(64) std::array<float, kRoom> middle;  ///< their distance along the ray; where layers come between them
  /// Of segments whose ends carry colours (Payload::color), in place of the scalars: r, g, b and extinction as a
  /// fraction of the largest. Of those that carry light (Payload::lit), besides the scalars: light and density.
  alignas(64) std::array<std::array<float, kRoom>, 4> front;
  alignas(64) std::array<std::array<float, kRoom>, 4> back;
  alignas(64) std::array<std::int32_t, kRoom> pixel;  ///< number of the pixel in its tile
  alignas(64) std::array<float, 4 * kRoom> rgba;      ///< the colours: premultiplied, four numbers a segment
};

}  // namespace havs
