#pragma once
// Why a rasterised picture differs from the reference at a pixel: the ray's fragments in double precision, and how far
// the pixel's colour moves when the rasteriser's roundings are put into them.
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "reference/ray_color.h"
#include "scene/prepared_scene.h"
#include "scene/view.h"

namespace havs::test {

/// A face where the ray of the pixel's centre meets it.
struct TracedFragment {
  Index face;
  int kind;                 ///< +1 entry into the mesh, -1 exit, 0 between two cells
  double distance, scalar;  ///< in double; distance as of CellSegment
  double angle;             ///< between face and ray, degrees
  double edge;              ///< from the pixel's centre to the nearest edge of the face, pixels
  double slope;             ///< change of distance over a pixel, |d/dx| + |d/dy|
  double floatError;        ///< what `slope` and the float coordinates of the face make of the distance
  double effect;            ///< greatest change of the pixel, any channel, when the face moves by so much
};

/// What a difference comes from.
enum class Cause {
  order,     ///< fragments came too late for the k-buffer
  rounding,  ///< float numbers, most of all on faces whose distance changes fast over the pixel: seen nearly edge on
  grid,      ///< corners snapped to the rasteriser's grid: beside an edge it shows another face than the ray meets
  none       ///< none of these gives the pixel's colour: the lookup, or a fault
};

/// What a ray meets and gathers, by one rule of coverage.
struct TracedRay {
  std::vector<TracedFragment> fragments;  ///< near ones first
  RayColor color{};
  double floatEffect = 0;  ///< sum of the fragments' effects, and what compositing in float may add
};

struct PixelTrace {
  int x = 0, y = 0;
  double error = 0;        ///< of the worst channel
  TracedRay exact;         ///< the ray of the pixel's centre; its colour must be the reference's
  TracedRay snapped;       ///< what a rasteriser shows whose corners lie on a grid of 1/256 pixel
  double gridEffect = 0;   ///< from the one to the other
  double unexplained = 0;  ///< from `snapped` to the picture
  std::size_t late = 0;    ///< fragments, where the picture has a certificate
  Cause cause = Cause::none;

  double smallestAngle() const;  ///< degrees
  double nearestEdge() const;    ///< pixels
};

/// Traces the pixels of one view. The scene must outlive it, and lie in front of the eye.
class PixelTracer {
 public:
  PixelTracer(const PreparedScene& prepared, const View& view);

  /// `picture` is what was drawn, `reference` the ground truth.
  PixelTrace trace(int x, int y, const Image& picture, const Image& reference, std::size_t late = 0) const;

 private:
  struct Corner {
    double x, y;      ///< pixels
    double nearness;  ///< 1 / distance along the view from the eye; orthographic: 1
    double depth;
  };
  /// A place on the rasteriser's grid, in 1/256 pixel from the centre of the first pixel.
  struct GridPoint {
    std::int64_t x, y;
  };
  /// Corners by number, and where they are instead.
  using GridMoves = std::map<Index, GridPoint>;
  struct Fragment {
    Index face;
    int kind;
    double distance, scalar;
  };
  /// Where a pixel's centre that lies on an edge counts as moved to.
  struct Tie {
    int x, y;
  };

  std::array<Corner, 3> cornersOf(Index face) const;
  std::vector<Index> facesNear(double x, double y) const;
  bool covers(Index face, double x, double y) const;
  double distanceToEdge(Index face, double x, double y) const;
  bool coversSnapped(Index face, int pixelX, int pixelY, const Tie& tie, const GridMoves& moves) const;
  std::vector<std::pair<Index, GridPoint>> doubtfulCorners(const std::vector<Index>& near, double x, double y) const;
  Fragment fragmentAt(Index face, double planeX, double planeY, double pixelX, double pixelY) const;
  RayColor composite(std::vector<Fragment> fragments) const;
  TracedFragment describe(const Fragment& fragment, double x, double y) const;
  double effectOf(const std::vector<Fragment>& fragments, std::size_t moved, double x, double y,
                  const RayColor& unmoved) const;
  TracedRay traceRay(const std::vector<Index>& faces, double x, double y) const;
  TracedRay snappedRay(const std::vector<Index>& near, int x, int y, const Tie& tie, const GridMoves& moves) const;
  TracedRay nearestSnapped(const std::vector<Index>& near, int x, int y, const RayColor& seen) const;

  const PreparedScene& prepared_;
  const View& view_;
  std::vector<Corner> corners_;
  std::vector<GridPoint> snapped_;  ///< of corners_
  double floatPixels_;              ///< error of a corner's place in float
};

/// One line: the pixel, and what explains it.
std::string summary(const PixelTrace& trace);
/// A line a fragment.
std::string listOf(const TracedRay& ray);
std::string nameOf(Cause cause);

}  // namespace havs::test
