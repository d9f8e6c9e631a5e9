#pragma once
// A face made ready for a tile: linear functions of the place in the tile, set up in double. Included by tile_kernel.h.
//
// With the corners as homogeneous points (x, y, w) relative to the tile's first pixel, each edge has the function
// E(x, y) of raster/edge_function.h, positive inside for one sense of the face. What is linear on the face in space,
// such as the depth, is at a pixel (sum of the corners' values times the opposite edges' E) / (sum of the E).
#include <cmath>
#include <cstdint>

#include "render/native/tile_draw.h"

namespace havs {
namespace {

/// Linear functions of a face: the three edges, their sum, the depth's numerator, those of what fragments carry. Set up
/// in double relative to the face's first stamp, so that float keeps the place across the face.
template <int kAttributes>
struct FaceFunctions {
  static constexpr int kSum = 3, kDepth = 4, kFirstAttribute = 5;
  static constexpr int kCount = 5 + kAttributes;
  float atOrigin[kCount], perX[kCount], perY[kCount];
  float depth0;                   ///< the first corner's, which the numerators are relative to
  float attribute0[kAttributes];  ///< the same
};

/// The face's corners in the order of their numbers.
struct FaceCorners {
  const RasterPoint* p[3];
  std::uint32_t index[3];
  bool reversed;  ///< an odd permutation of the face's own order
};

inline FaceCorners cornersOf(const RasterMesh& mesh, std::uint32_t face) {
  const std::uint32_t* v = mesh.faces[face];
  std::uint32_t a = v[0], b = v[1], c = v[2];
  bool reversed = false;
  auto order = [&reversed](std::uint32_t& low, std::uint32_t& high) {
    const bool swap = high < low;
    const std::uint32_t least = swap ? high : low;
    high = swap ? low : high;
    low = least;
    reversed ^= swap;
  };
  order(a, b);
  order(b, c);
  order(a, b);
  return {{mesh.points + a, mesh.points + b, mesh.points + c}, {a, b, c}, reversed};
}

/// How a face is drawn.
enum class FaceWay {
  nothing,
  stamps,        ///< by the functions, in float within a stamp
  pixelByPixel,  ///< in double: seen edge on, or partly behind the eye
};

/// A face whose height is a smaller part of its extent in the tile is drawn pixel by pixel: float would lose the place
/// across it.
constexpr double kLeastHeight = 1.0 / 64;
/// Of |perX| + |perY| and a pixel of extent: what float may be off by, in the value of an edge function. Four roundings
/// of 2^-24 each of at most twice the extent.
constexpr double kFloatError = 0x1p-21;

struct Homogeneous {
  double x, y, w;
};

struct Linear {
  double atOrigin, perX, perY;
};

/// E of the edge from a to b.
inline Linear edgeOf(const Homogeneous& a, const Homogeneous& b) {
  return {a.x * b.y - a.y * b.x, a.y * b.w - a.w * b.y, a.w * b.x - a.x * b.w};
}

/// Bound of the rounding of E as edgeOf and the pixel loop compute it, beside the float part: see edgeLimit.
inline double doubleError(const Homogeneous& a, const Homogeneous& b, double reach) {
  const double ax = std::abs(a.x) + reach * std::abs(a.w), ay = std::abs(a.y) + reach * std::abs(a.w);
  const double bx = std::abs(b.x) + reach * std::abs(b.w), by = std::abs(b.y) + reach * std::abs(b.w);
  return 16 * 0x1p-53 * (ax * by + ay * bx);
}

}  // namespace
}  // namespace havs
