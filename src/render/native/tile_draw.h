#pragma once
// What a tile kernel works on. Plain data: kernels are compiled for instruction sets that the rest of the program may
// not be run on.
#include <cstddef>
#include <cstdint>

#include "raster/screen_points.h"
#include "render/native/segment_queue.h"
#include "render/native/tile_light.h"

namespace havs {

struct RayLayer;

/// Pixels are drawn in stamps of 4 x 4, whatever the lanes, so that their arithmetic is the same for all: lane i is the
/// pixel (i % 4, i / 4) of its stamp.
inline constexpr int kStampSide = 4;
inline constexpr int kStampPixels = kStampSide * kStampSide;
inline constexpr int kLargestK = 14;
inline constexpr int kLargestTileStamps = 64;  ///< across a tile

/// A point of the mesh in the picture: a cache line.
struct alignas(64) RasterPoint : ScreenPoint {
  double column, row;  ///< x / w, y / w; 0 behind the eye
  double scalar;       ///< of [0, 1]; point data
};

/// The mesh as one view sees it.
struct RasterMesh {
  const RasterPoint* points;
  const std::uint32_t (*faces)[3];  ///< corners; the normal points out of the mesh where the face is on its boundary
  const float (*behind)[2];  ///< cell data: scalars behind each face as seen from its front and its back; or null
  const float (*colors)[4];  ///< Payload::color: of the points, or of both sides of the faces (cell data); or null
  const std::uint32_t (*cells)[4];  ///< corners, where cells are drawn instead of faces; or null
  const float* ofCells;             ///< then, cell data: their scalars; or null
  double fixedDepth;                ///< of a plane across the view that depths are taken relative to, and its
  double fixedDistance;             ///< distance from the eye, > 0; 1 for parallel rays
  bool cellData;
  bool isosurfaces;  ///< scalars stay within those of a face's corners, also in float
  bool parallelRays;
  int width, height;  ///< of the picture
};

/// A face of a tile's list: its number, and whether it is on the mesh's boundary.
inline constexpr std::uint32_t kBoundaryBit = 0x80000000u;

/// A tile being drawn by one thread. Stamps lie row by row, `stampsAcross` a row.
struct TileDraw {
  RasterMesh mesh;
  const std::uint32_t* faces;  ///< of the tile, near first (kBoundaryBit)
  std::size_t faceCount;
  int left, top;  ///< of the tile in the picture
  int stampsAcross, stampsDown;

  // Of each stamp, and of the pixels in it
  std::uint16_t* active;   ///< pixels that fragments are taken for: bit i of lane i
  std::uint16_t* flagged;  ///< pixels whose order has proven wrong
  float* state;            ///< the k-buffer, begun by the kernel
  const float* rayScale;   ///< length along the ray for one unit of depth
  float* rgba;             ///< of each pixel, four numbers, premultiplied
  std::uint32_t* late;     ///< of each pixel: late fragments; null: not counted

  const RayLayer* layers;         ///< of all pixels of the picture; null: none come between segments
  std::uint32_t* nextLayer;       ///< of each pixel: the first of these that is not composited yet
  const std::uint32_t* endLayer;  ///< of each pixel: behind its last one

  std::size_t activePixels;  ///< the drawing ends when none is left
  bool compositeLate;
  /// By how much a fragment may be nearer than the one before it, for the order to be believed and not the distances
  /// (SortMethod::isBelieved): of several fragments in one place the last says what lies behind it.
  float sameDistance;
  bool flushAlways;  ///< after every stamp's segments, so that pixels are done exactly when their opacity says so
  std::uint64_t fragments;
  std::uint64_t lateFragments;  ///< that a kernel of the full k has met

  const TileLight* light;  ///< Payload::lit; or null
  SegmentQueue* queue;
  /// Colours the queue's segments, composites them and empties it.
  void (*flush)(TileDraw& tile);
  const void* shader;     ///< for flush
  float terminalOpacity;  ///< of early termination; above 1: never
};

}  // namespace havs
