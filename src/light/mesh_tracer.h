#pragma once
// Optical depth along rays from the points of a mesh, through its tetrahedra.
//
// A ray is seen along itself (light/line_frame.h): it goes from cell to cell through the triangles that contain it,
// decided by signs alone, so that points, edges and faces that it meets exactly, slivers and flat cells are no special
// cases: it leaves every cell that it enters (after Platis and Theoharis 2003, Fast Ray-Tetrahedron Intersection Using
// Pluecker Coordinates, here with exact signs). Where it meets points or edges it goes beside them, by an
// infinitesimal. From a point of the boundary rays are turned towards the inside by 1e-12: one along the boundary
// counts as inside. Where it leaves the mesh, the boundary faces that it enters again through are found in a tree
// (light/boundary_tree.h).
//
// Cells are taken not to overlap; where they do, both count.
#include <limits>
#include <vector>

#include "light/boundary_tree.h"
#include "light/extinction_integral.h"
#include "light/medium.h"
#include "light/point_cells.h"
#include "light/star.h"

namespace havs {

class MeshTracer {
 public:
  /// Prepares in parallel, linear time but for sorting the boundary. What `medium` refers to must outlive the tracer.
  explicit MeshTracer(const Medium& medium);

  const Medium& medium() const { return medium_; }
  const PointCells& cellsAround() const { return around_; }

 private:
  friend class PointRays;
  struct Crossing {
    double along, scalar;
  };
  enum class Ended { outside, early, atStart };
  Crossing crossing(const LineTriangle& triangle, Index cell) const;
  template <class Sums>
  Ended walk(const LineFrame& line, LineTriangle& triangle, Crossing& at, Index cell, Index start, Sums& sums) const;
  template <class Sums>
  void trace(Star& star, const Vec3& direction, Sums& sums) const;

  Medium medium_;
  ExtinctionIntegral extinction_;
  std::vector<Node> nodes_;
  std::vector<LinkedCell> cells_;
  PointCells around_;
  BoundaryTree boundary_;
};

/// Rays from one point after another, of a mesh that others may look through at the same time. Directions have length
/// 1, distances are in local units.
class PointRays {
 public:
  static constexpr double kEndless = std::numeric_limits<double>::infinity();

  /// The tracer must outlive it.
  explicit PointRays(const MeshTracer& tracer) : tracer_(tracer) {}

  /// Rays start at this point of the mesh from now on. It must be a point of the medium; from one without cells
  /// on, only what rays enter through the boundary counts.
  void startAt(Index point);

  /// The integral of kappa along the ray over distances from `from` to `to`; there is none outside the mesh. Infinite
  /// where the ray meets an opaque interval of the curve there, its ends and the start included. At least 0, never NaN.
  double opticalDepth(const Vec3& direction, double from = 0, double to = kEndless);

  /// exp(-opticalDepth), to the same digits, in less time in the dark.
  double transmittance(const Vec3& direction, double from = 0, double to = kEndless);

  /// What a ball about the point knows of one ray.
  struct BallRay {
    double opticalDepth = 0;  ///< as above, from 0 to the radius
    /// Integral of kappa r^2 over distances r: its mean over all directions times 3 / radius^3 is the mean of kappa
    /// over the ball. Opaque surfaces count with the kappa that the curve has there.
    double moment = 0;
  };
  BallRay ballRay(const Vec3& direction, double radius);

 private:
  const MeshTracer& tracer_;
  Star star_;
};

}  // namespace havs
