#pragma once
#include <cstdint>
#include <span>

#include "mesh/faces.h"
#include "mesh/tet_mesh.h"
#include "transfer/extinction_curve.h"

namespace havs {

/// What light goes through: a mesh of right-handed cells and its extinction. Holds references only; what they refer to
/// must outlive it.
struct Medium {
  std::span<const Vec3> points;  ///< local frame: within about 1 of the origin
  std::span<const Tetrahedron> cells;
  const Faces& faces;               ///< of these cells
  std::span<const double> scalars;  ///< of [0, 1]; one a point, or one a cell
  bool cellData = false;            ///< one a cell: the scalar is constant in each
  const ExtinctionCurve& curve;     ///< kappa per local unit
};

/// Which points something is computed for, one byte a point, 0: not; empty: all.
using PointMask = std::span<const std::uint8_t>;
inline bool isIn(PointMask mask, std::size_t point) { return mask.empty() || mask[point] != 0; }

}  // namespace havs
