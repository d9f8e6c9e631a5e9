#pragma once
#include <span>
#include <vector>

#include "mesh/tet_mesh.h"
#include "raster/screen_points.h"

namespace havs {

/// Where a ray is inside a cell. Distances are along the ray in local units, relative to the plane through the mesh's
/// centre across the view.
struct CellSegment {
  double entry, exit;              ///< entry <= exit
  double scalarEntry, scalarExit;  ///< of [0, 1]
  Index cell;
};

/// What rays of a view meet.
struct ScreenMesh {
  std::span<const Tetrahedron> cells;
  std::vector<ScreenPoint> points;
  std::span<const double> scalars;  ///< one a point, or one a cell
  bool cellData = false;
  double eyeDepth = 0;  ///< perspective: depth of the eye
  int width = 0, height = 0;
};

/// The segments of the pixels of a rectangle, cell by cell as they come.
class SegmentCollector {
 public:
  explicit SegmentCollector(const ScreenMesh& mesh) : mesh_(mesh) {}

  /// Starts anew with another rectangle.
  void reset(const PixelBox& rectangle);
  /// Adds the segments of a cell at all pixels of `box` within the rectangle. Depths stand for distances: both times
  /// the pixel's View::rayScale.
  void add(Index cell, const PixelBox& box);
  /// The segments of a pixel, sorted by entry, then exit, then number of the cell. Every point of the ray belongs to
  /// one of them at most: where cells overlap, to the one entered first. Valid until the next call.
  std::span<const CellSegment> at(int x, int y, double rayScale);

 private:
  struct Found {
    CellSegment segment;
    std::uint32_t pixel;
  };
  struct Cell;
  void addAt(const Cell& cell, const std::array<double, 6>& products, int x, int y);
  void addExactlyAt(const Cell& cell, int x, int y);
  void addFaces(const Cell& cell, const std::array<double, 6>& products, int first, int second, int x, int y);
  void addFromEye(const Cell& cell, const std::array<double, 6>& products, const std::array<int, 6>& signs, int face,
                  int x, int y);
  void add(const CellSegment& segment, int x, int y);
  void groupByPixel();

  const ScreenMesh& mesh_;
  PixelBox rectangle_{};
  std::vector<Found> found_;
  bool grouped_ = false;
  std::vector<std::uint32_t> begin_;  ///< of each pixel's segments in grouped order
  std::vector<CellSegment> segments_;
  std::vector<CellSegment> settled_;
};

}  // namespace havs
