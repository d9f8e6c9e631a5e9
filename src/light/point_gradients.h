#pragma once
#include <span>
#include <vector>

#include "light/medium.h"
#include "light/point_cells.h"

namespace havs {

/// The gradient of the scalar at each point, per local unit: the mean of the gradients in the cells around it, weighted
/// by volume over the cube of the distance of the cell's centre, which is about the part of the view that a cell takes.
/// Exact for linear fields wherever the point lies, of first order else. Why this mean and not another, nor least
/// squares: docs/08-effects-data.md. Cell data are first averaged to the points, by the
/// volumes of the cells around (which shifts values near the boundary, so that there linear data do not come out
/// exactly). 0 at points whose cells are all flat, that no cell has, or that are not in the mask; never NaN.
///
/// `scalars`: one a point, or one a cell; `around`: of these cells. Parallel; the result does not depend on the number
/// of threads.
std::vector<Vec3> pointGradients(std::span<const Vec3> points, std::span<const Tetrahedron> cells,
                                 const PointCells& around, std::span<const double> scalars, bool cellData,
                                 PointMask mask = {});

/// Cell data at the points: the mean over the cells around each, weighted by volume; where all are flat, by number; 0
/// where there is none.
std::vector<double> pointAverages(std::span<const Vec3> points, std::span<const Tetrahedron> cells,
                                  const PointCells& around, std::span<const double> cellScalars);

}  // namespace havs
