#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "transfer/extinction_curve.h"

namespace havs {

/// What a ray gathers on one segment: colour premultiplied, and opacity.
struct SegmentColor {
  std::array<double, 3> color{0, 0, 0};
  double alpha = 0;
};

/// The exact integral (docs/02-method.md, Integration) over a segment on which the scalar goes linearly from sFront to
/// sBack in `length` (local units), piece by piece between the curve's knots. Opaque surfaces are not regarded here:
/// the caller cuts the segment at them (firstOpaque).
SegmentColor integrateSegment(const ExtinctionCurve& curve, double sFront, double sBack, double length);

/// Fraction of the way from sFront to sBack at which the scalar first lies in an opaque interval; > 1 when it never
/// does.
double firstOpaque(const ExtinctionCurve& curve, double sFront, double sBack);

/// The table of the paper: (front scalar, back scalar, length) -> premultiplied colour and opacity.
struct Table3d {
  int size = 0;     ///< entries along both scalars; entry i of an axis of n stands for i / (n - 1) of its range
  int lengths = 0;  ///< entries along the length
  double maximumLength = 0;  ///< of the last entry along the length axis, local units
  std::vector<float> rgba;   ///< 4 floats an entry; entry (f, b, l) at ((l * size + b) * size + f) * 4
};

/// Builds every entry with integrateSegment's arithmetic in double, rounded to float once, in parallel. size: 2 to 512;
/// maximumLength: local units, > 0. Throws Error{input} for others. The result does not depend on the number of
/// threads.
Table3d buildTable3d(const ExtinctionCurve& curve, int size, double maximumLength, const Progress& progress = {});

/// Brings a table of the curve `before` up to date with `after`, bit for bit what buildTable3d gives: only entries
/// whose [min(front, back), max(front, back)] the change touches are built.
void rebuildTable3d(Table3d& table, const ExtinctionCurve& before, const ExtinctionCurve& after);

}  // namespace havs
