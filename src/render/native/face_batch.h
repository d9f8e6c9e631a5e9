#pragma once
// Faces made ready for a tile, sixteen at a time: the loops over a batch are simple enough for the compiler to put on
// SIMD lanes. Included by tile_kernel.h.
//
// With the corners as homogeneous points (x, y, w), each edge has the function E(x, y) of raster/edge_function.h,
// positive inside for one sense of the face. What is linear on the face in space, such as the depth, is at a pixel (sum
// of the corners' values times the opposite edges' E) / (sum of the E). All is set up in double relative to the first
// stamp of the face in the picture, so that float keeps the place across the face, and the same in every tile.
#include <cmath>
#include <cstdint>

#include "render/native/tile_draw.h"

namespace havs {
namespace {

constexpr int kBatch = 16;

/// A face's corners in the order of their numbers.
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
enum class FaceWay : std::uint8_t {
  nothing,
  stamps,        ///< by the functions, in float
  pixelByPixel,  ///< in double: seen edge on, or partly behind the eye
};

/// A face whose height is a smaller part of its extent in the picture is drawn pixel by pixel: float would lose the
/// place across it. At a pixel where the face is w away, the edges' functions sum to determinant / w: what float loses
/// of them is the greater part of that the farther it is.
constexpr double kLeastHeight = 1.0 / 64;
/// Of |perX| + |perY| and a pixel of extent: what float may be off by, in the value of an edge function. Six roundings
/// of 2^-24 of at most the extent.
constexpr double kFloatError = 0x1p-21;
/// Of the products of an edge function's terms: the rounding in double, as edgeLimit (raster/edge_function.h) has it.
constexpr double kDoubleError = 16 * 0x1p-53;

constexpr int kFewValues = 5;  ///< not worth to count those that are used

/// kValues: what is interpolated across a face.
template <int kMostValues>
struct FaceBatch {
  static constexpr int kValues = kMostValues;
  static constexpr int kSum = 3, kNumerator = 4;  ///< behind the edges' functions; a numerator for each value
  static constexpr int kFunctions = kNumerator + kValues;
  int values = kValues;  ///< of these, so many are used
  using Doubles = double[kBatch];
  using Floats = float[kBatch];

  FaceCorners corners[kBatch];
  std::uint32_t face[kBatch];
  bool boundary[kBatch], entersMesh[kBatch];
  FaceWay way[kBatch];
  int left[kBatch], top[kBatch], right[kBatch], bottom[kBatch];  ///< pixels of the tile, both ends included
  int originX[kBatch], originY[kBatch];  ///< pixel of the picture that functions start at: of the face's first stamp
  int extent[kBatch];                    ///< in pixels, of the face in the picture, and a stamp

  alignas(64) Doubles x[3], y[3], w[3], column[3], row[3], depth[3];
  alignas(64) Doubles value[kValues][3];                                 ///< at the corners; set by the drawer
  alignas(64) Doubles atOriginD[3], perXD[3], perYD[3], error[3], sign;  ///< of the edges opposite to the corners

  alignas(64) Floats atOrigin[kFunctions], perX[kFunctions], perY[kFunctions];
  alignas(64) Floats value0[kValues];  ///< the first corner's, which the numerators are relative to
  alignas(64) Floats kind;
  alignas(64) Floats low, high;  ///< of a value that has bounds; set by the drawer

  /// What lies behind `count` repeats the last face, and is not drawn.
  void gather(const TileDraw& tile, const std::uint32_t* listed, int count) {
    for (int i = 0; i < kBatch; ++i) {
      const std::uint32_t which = listed[i < count ? i : count - 1];
      face[i] = which & ~kBoundaryBit;
      boundary[i] = (which & kBoundaryBit) != 0;
      corners[i] = cornersOf(tile.mesh, face[i]);
      for (int j = 0; j < 3; ++j) {
        const RasterPoint& p = *corners[i].p[j];
        x[j][i] = p.x;
        y[j][i] = p.y;
        w[j][i] = p.w;
        column[j][i] = p.column;
        row[j][i] = p.row;
        depth[j][i] = p.depth;
      }
    }
  }

  void findBoxes(const TileDraw& tile) {
    constexpr double kMargin = 1e-6;  // for the rounding of the divisions
    const int lastX = kStampSide * tile.stampsAcross - 1, lastY = kStampSide * tile.stampsDown - 1;
    for (int i = 0; i < kBatch; ++i) {
      const int firstColumn = firstPixel(least(column, i) - 0.5 - kMargin, tile.mesh.width - 1);
      const int firstRow = firstPixel(least(row, i) - 0.5 - kMargin, tile.mesh.height - 1);
      const int lastColumn = lastPixel(most(column, i) - 0.5 + kMargin, tile.mesh.width - 1);
      const int lastRow = lastPixel(most(row, i) - 0.5 + kMargin, tile.mesh.height - 1);
      originX[i] = firstColumn / kStampSide * kStampSide;
      originY[i] = firstRow / kStampSide * kStampSide;
      const int width = lastColumn - firstColumn, height = lastRow - firstRow;
      extent[i] = kStampSide + (width > height ? width : height);
      left[i] = firstColumn > tile.left ? firstColumn - tile.left : 0;
      top[i] = firstRow > tile.top ? firstRow - tile.top : 0;
      right[i] = lastColumn - tile.left < lastX ? lastColumn - tile.left : lastX;
      bottom[i] = lastRow - tile.top < lastY ? lastRow - tile.top : lastY;
    }
    for (int i = 0; i < kBatch; ++i) {
      way[i] = left[i] <= right[i] && top[i] <= bottom[i] ? FaceWay::stamps : FaceWay::nothing;
      if (w[0][i] > 0 && w[1][i] > 0 && w[2][i] > 0) continue;
      way[i] = FaceWay::pixelByPixel;
      left[i] = top[i] = 0;
      right[i] = lastX;
      bottom[i] = lastY;
    }
  }

  /// Edges and determinants; decides which faces are too thin for float.
  void findEdges() {
    Doubles determinant, thinness;
    for (int i = 0; i < kBatch; ++i) {
      const double x0 = originX[i] + 0.5, y0 = originY[i] + 0.5;
      for (int j = 0; j < 3; ++j) {
        x[j][i] -= x0 * w[j][i];
        y[j][i] -= y0 * w[j][i];
      }
    }
    for (int i = 0; i < kBatch; ++i) {
      const double across = extent[i];
      const double farthest = most(w, i);
      double thinnest = 0;
      for (int j = 0; j < 3; ++j) {
        const int a = (j + 1) % 3, b = (j + 2) % 3;
        atOriginD[j][i] = x[a][i] * y[b][i] - y[a][i] * x[b][i];
        perXD[j][i] = y[a][i] * w[b][i] - w[a][i] * y[b][i];
        perYD[j][i] = w[a][i] * x[b][i] - x[a][i] * w[b][i];
        const double run = std::abs(perXD[j][i]) + std::abs(perYD[j][i]);  // at least the edge's length times w w
        const double ax = std::abs(x[a][i]) + across * std::abs(w[a][i]);
        const double ay = std::abs(y[a][i]) + across * std::abs(w[a][i]);
        const double bx = std::abs(x[b][i]) + across * std::abs(w[b][i]);
        const double by = std::abs(y[b][i]) + across * std::abs(w[b][i]);
        error[j][i] = kFloatError * across * run + kDoubleError * (ax * by + ay * bx);
        const double thin = across * farthest * run;
        thinnest = thin > thinnest ? thin : thinnest;
      }
      determinant[i] = w[0][i] * atOriginD[0][i] + x[0][i] * perXD[0][i] + y[0][i] * perYD[0][i];
      thinness[i] = kLeastHeight * thinnest;
      sign[i] = determinant[i] > 0 ? 1.0 : -1.0;
    }
    for (int i = 0; i < kBatch; ++i) {
      if (way[i] == FaceWay::stamps && !(std::abs(determinant[i]) > thinness[i])) way[i] = FaceWay::pixelByPixel;
      entersMesh[i] = (determinant[i] < 0) != corners[i].reversed;
      kind[i] = !boundary[i] ? 0.0f : entersMesh[i] ? 1.0f : -1.0f;
    }
  }

  /// A function in float: `scale` times what it is at the origin, and per pixel.
  void put(int which, int i, double atOriginValue, double perXValue, double perYValue, double scale) {
    atOrigin[which][i] = static_cast<float>(scale * atOriginValue);
    perX[which][i] = static_cast<float>(scale * perXValue);
    perY[which][i] = static_cast<float>(scale * perYValue);
  }

  /// The functions in float. A sign of an edge's is sure where the value exceeds its error: scaled so that this is 1.
  void findFunctions() {
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < kBatch; ++i) put(j, i, atOriginD[j][i], perXD[j][i], perYD[j][i], sign[i] / error[j][i]);
    for (int i = 0; i < kBatch; ++i)
      put(kSum, i, atOriginD[0][i] + atOriginD[1][i] + atOriginD[2][i], perXD[0][i] + perXD[1][i] + perXD[2][i],
          perYD[0][i] + perYD[1][i] + perYD[2][i], sign[i]);
    for (int v = 0; v < (kValues > kFewValues ? values : kValues); ++v)
      for (int i = 0; i < kBatch; ++i) {
        const double b = value[v][1][i] - value[v][0][i], c = value[v][2][i] - value[v][0][i];
        put(kNumerator + v, i, b * atOriginD[1][i] + c * atOriginD[2][i], b * perXD[1][i] + c * perXD[2][i],
            b * perYD[1][i] + c * perYD[2][i], sign[i]);
        value0[v][i] = static_cast<float>(value[v][0][i]);
      }
  }

 private:
  static double least(const Doubles* of, int i) {
    const double ab = of[0][i] < of[1][i] ? of[0][i] : of[1][i];
    return ab < of[2][i] ? ab : of[2][i];
  }
  static double most(const Doubles* of, int i) {
    const double ab = of[0][i] > of[1][i] ? of[0][i] : of[1][i];
    return ab > of[2][i] ? ab : of[2][i];
  }
  /// The next number above, 0 at the least; of a value beyond `last`, a larger one.
  static int firstPixel(double low, int last) {
    const double inside = low < 0.0 ? 0.0 : low > last + 1.0 ? last + 1.0 : low;
    const int down = static_cast<int>(inside);
    return down + (static_cast<double>(down) < inside ? 1 : 0);
  }
  /// The next number below, `last` at most; of a value below 0, -1.
  static int lastPixel(double high, int last) {
    const double inside = high < 0.0 ? -1.0 : high > last ? static_cast<double>(last) : high;
    return static_cast<int>(inside);
  }
};

}  // namespace
}  // namespace havs
