#pragma once
// Cells made ready for a tile, sixteen at a time. A ray is in a cell between the last of the planes that it comes to
// through faces towards the eye and the first of the others. With w the distance from the eye and u = w - w0, where w0
// is that of a fixed plane, t = u / w grows along the ray, and on a plane in space it is linear across the picture; for
// parallel rays so is u itself. So entry and exit are the greatest and the least of linear functions, without an edge,
// a fill rule or a division.
//
// Both cells of a face must see the very same plane, or there would be gaps and overlaps where it is seen edge on: its
// function comes from its three corners alone, in the order of their numbers, relative to a pixel that the cells share.
//
// Included by gather_kernel.h.
#include <cmath>
#include <cstdint>
#include <limits>

#include "render/native/face_batch.h"
#include "render/native/tile_draw.h"

namespace havs {
namespace {

/// Functions are relative to the first pixel of a block of so many, whatever the tiles, which must be parts of blocks.
constexpr int kBlockSide = 64;
inline int blockOf(int pixel) { return pixel / kBlockSide * kBlockSide; }

struct CellBatch {
  using Doubles = double[kBatch];
  using Floats = float[kBatch];
  /// Functions of a cell: t of three faces towards the eye and of three away from it, some twice; the scalar where the
  /// ray meets the fixed plane, and its change along the ray.
  static constexpr int kFront = 0, kBack = 3, kScalar = 6, kRate = 7, kFunctions = 8;

  const RasterPoint* corner[kBatch][4];  ///< in the order of their numbers
  std::uint32_t cell[kBatch];
  std::int32_t drawn[kBatch];                                    ///< 0 or 1
  int left[kBatch], top[kBatch], right[kBatch], bottom[kBatch];  ///< pixels of the tile, both ends included

  /// At the first pixel of the block that the tile is a part of, and per pixel.
  alignas(64) Floats atOrigin[kFunctions], perX[kFunctions], perY[kFunctions];
  alignas(64) Floats nearest, farthest;  ///< t of the corners
  alignas(64) Floats leastScalar, mostScalar;

  void gather(const TileDraw& tile, const std::uint32_t* listed, int count) {
    const double originX = blockOf(tile.left) + 0.5, originY = blockOf(tile.top) + 0.5;
    for (int i = 0; i < kBatch; ++i) {
      cell[i] = listed[i < count ? i : count - 1];
      std::uint32_t v[4];
      for (int j = 0; j < 4; ++j) v[j] = tile.mesh.cells[cell[i]][j];
      order(v[0], v[1]);
      order(v[2], v[3]);
      order(v[0], v[2]);
      order(v[1], v[3]);
      order(v[1], v[2]);
      for (int j = 0; j < 4; ++j) {
        const RasterPoint& p = *(corner[i][j] = tile.mesh.points + v[j]);
        x_[j][i] = p.x - originX * p.w;
        y_[j][i] = p.y - originY * p.w;
        w_[j][i] = p.w;
        column_[j][i] = p.column;
        row_[j][i] = p.row;
        u_[j][i] = p.depth - tile.mesh.fixedDepth;
        scalar_[j][i] = tile.mesh.cellData ? static_cast<double>(tile.mesh.ofCells[cell[i]]) : p.scalar;
      }
    }
  }

  void prepare(const TileDraw& tile) {
    findBoxes(tile);
    findRange(tile.mesh);
    findScalars(tile.mesh);
    findPlane<0, 1, 2, 3>(tile.mesh);
    findPlane<1, 0, 2, 3>(tile.mesh);
    findPlane<2, 0, 1, 3>(tile.mesh);
    findPlane<3, 0, 1, 2>(tile.mesh);
    for (int i = 0; i < kBatch; ++i)
      if (drawn[i]) assign(i);
  }

 private:
  static void order(std::uint32_t& low, std::uint32_t& high) {
    const std::uint32_t least = low < high ? low : high;
    high = low < high ? high : low;
    low = least;
  }
  static double least(double a, double b) { return a < b ? a : b; }
  static double most(double a, double b) { return a > b ? a : b; }
  /// First and last pixel of the tile whose centres lie between the places low and high, by a margin for rounding.
  static void pixelsBetween(double low, double high, int start, int last, int& first, int& end) {
    constexpr double kMargin = 1e-6;
    const double from = least(most(low - kMargin - 0.5 - start, 0), last + 1);
    const double to = least(most(high + kMargin - 0.5 - start, -1), last);
    const int below = static_cast<int>(from);
    first = below + (from > below ? 1 : 0);
    end = static_cast<int>(to + 1) - 1;
  }

  void findBoxes(const TileDraw& tile) {
    const int lastX = kStampSide * tile.stampsAcross - 1, lastY = kStampSide * tile.stampsDown - 1;
    for (int i = 0; i < kBatch; ++i) {
      auto low = [i](const Doubles* of) { return least(least(of[0][i], of[1][i]), least(of[2][i], of[3][i])); };
      auto high = [i](const Doubles* of) { return most(most(of[0][i], of[1][i]), most(of[2][i], of[3][i])); };
      pixelsBetween(low(column_), high(column_), tile.left, lastX, left[i], right[i]);
      pixelsBetween(low(row_), high(row_), tile.top, lastY, top[i], bottom[i]);
      const bool beforeEye = low(w_) > 0;  // the mesh has been cut at the eye (scene/eye_plane.h)
      drawn[i] = (beforeEye ? 1 : 0) & (left[i] <= right[i] ? 1 : 0) & (top[i] <= bottom[i] ? 1 : 0);
    }
  }

  void findRange(const RasterMesh& mesh) {
    for (int i = 0; i < kBatch; ++i) {
      double t[4];
      for (int j = 0; j < 4; ++j) t[j] = mesh.parallelRays ? u_[j][i] : u_[j][i] / w_[j][i];
      nearest[i] = static_cast<float>(least(least(t[0], t[1]), least(t[2], t[3])));
      farthest[i] = static_cast<float>(most(most(t[0], t[1]), most(t[2], t[3])));
      const Doubles* s = scalar_;
      leastScalar[i] = static_cast<float>(least(least(s[0][i], s[1][i]), least(s[2][i], s[3][i])));
      mostScalar[i] = static_cast<float>(most(most(s[0][i], s[1][i]), most(s[2][i], s[3][i])));
    }
  }

  /// The scalar is linear in space: on the ray it is that where the ray meets the fixed plane, and its rate times u.
  void findScalars(const RasterMesh& mesh) {
    const double across = mesh.parallelRays ? 0 : 1;
    const double scale = mesh.parallelRays ? 1 : mesh.fixedDistance;
    for (int i = 0; i < kBatch; ++i) {
      double e[3][3], s[3];
      for (int j = 0; j < 3; ++j) {
        e[j][0] = x_[j][i] - x_[3][i];
        e[j][1] = y_[j][i] - y_[3][i];
        e[j][2] = u_[j][i] - u_[3][i];
        s[j] = scalar_[j][i] - scalar_[3][i];
      }
      double g[3], volume = 0;
      for (int c = 0; c < 3; ++c) {
        const int c1 = (c + 1) % 3, c2 = (c + 2) % 3;
        const double n0 = e[1][c1] * e[2][c2] - e[1][c2] * e[2][c1];
        const double n1 = e[2][c1] * e[0][c2] - e[2][c2] * e[0][c1];
        const double n2 = e[0][c1] * e[1][c2] - e[0][c2] * e[1][c1];
        g[c] = s[0] * n0 + s[1] * n1 + s[2] * n2;
        volume += e[0][c] * n0;
      }
      const double per = 1 / (volume != 0 ? volume : kInfinity);
      for (double& component : g) component *= per;
      put(kScalar, i, scalar_[3][i] - (g[0] * x_[3][i] + g[1] * y_[3][i] + g[2] * u_[3][i]), scale * g[0],
          scale * g[1]);
      put(kRate, i, g[2], across * g[0], across * g[1]);
    }
  }

  /// The function of the face opposite to a corner. All but whether rays enter the cell through it comes from its
  /// corners a, b, c alone.
  template <int face, int a, int b, int c>
  void findPlane(const RasterMesh& mesh) {
    const double scale = mesh.parallelRays ? 1 : mesh.fixedDistance;
    const double central = mesh.parallelRays ? 0 : 1, parallel = 1 - central;  // factors, as a choice hinders SIMD
    Plane& plane = plane_[face];
    for (int i = 0; i < kBatch; ++i) {
      const double ax = x_[a][i], ay = y_[a][i], aw = w_[a][i];
      const double bx = x_[b][i] - ax, by = y_[b][i] - ay, bu = u_[b][i] - u_[a][i];
      const double cx = x_[c][i] - ax, cy = y_[c][i] - ay, cu = u_[c][i] - u_[a][i];
      const double mx = by * cu - bu * cy, my = bu * cx - bx * cu, mz = bx * cy - by * cx;
      const double inPlane = mx * ax + my * ay;
      const double dx = x_[face][i] - ax, dy = y_[face][i] - ay, du = u_[face][i] - u_[a][i];
      // At the eye the plane's value is -q (parallel rays: towards it); the fourth corner tells where the cell is.
      const double distance = central * aw + parallel;
      const double q = central * inPlane + mz * distance;
      const double behind = mx * dx + my * dy + mz * du;
      const double size = std::abs(mx) + std::abs(my) + std::abs(mz) * distance;
      const double floor = kEdgeOn * size;
      const double safe = std::abs(q) > floor ? q : q < 0 ? -floor : floor;
      const double per = 1 / (size > 0 ? safe : kInfinity);
      plane.atOrigin[i] = static_cast<float>((inPlane + mz * u_[a][i]) * per);
      plane.perX[i] = static_cast<float>(-scale * mx * per);
      plane.perY[i] = static_cast<float>(-scale * my * per);
      plane.front[i] =
          (safe > 0) == (behind > 0) ? 1 : 0;  // of q = 0 as the function has it, or in and out change places
    }
  }

  /// Planes to the cell's functions; without any on one side, which only a flat cell can be, there is nothing to draw.
  void assign(int i) {
    int fronts = 0, backs = 0, front[4], back[4];
    for (int face = 0; face < 4; ++face) {
      front[fronts] = face;
      back[backs] = face;
      fronts += plane_[face].front[i];
      backs += 1 - plane_[face].front[i];
    }
    if (fronts == 0 || backs == 0) {
      drawn[i] = 0;
      return;
    }
    for (int slot = 0; slot < 3; ++slot) {
      take(kFront + slot, i, front[slot < fronts ? slot : 0]);
      take(kBack + slot, i, back[slot < backs ? slot : 0]);
    }
  }

  void take(int function, int i, int face) {
    const Plane& plane = plane_[face];
    atOrigin[function][i] = plane.atOrigin[i];
    perX[function][i] = plane.perX[i];
    perY[function][i] = plane.perY[i];
  }
  void put(int function, int i, double atOriginValue, double perXValue, double perYValue) {
    atOrigin[function][i] = static_cast<float>(atOriginValue);
    perX[function][i] = static_cast<float>(perXValue);
    perY[function][i] = static_cast<float>(perYValue);
  }

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  /// A plane is taken to pass the eye at no less than this part of its size: its function stays finite.
  static constexpr double kEdgeOn = 1e-14;

  struct Plane {
    Floats atOrigin, perX, perY;
    std::int32_t front[kBatch];  ///< 1: rays enter the cell through it
  };
  alignas(64) Doubles x_[4], y_[4], w_[4], u_[4], column_[4], row_[4], scalar_[4];
  alignas(64) Plane plane_[4];
};

}  // namespace
}  // namespace havs
