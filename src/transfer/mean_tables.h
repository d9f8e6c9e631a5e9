#pragma once
// Tables of mean colours: what a segment shows divided by its opacity. They are smoother than premultiplied colours,
// and the opacity, which is known in closed form, need not be interpolated.
#include <vector>

#include "transfer/preintegration.h"

namespace havs {

/// Extinction, per local unit, that mean colours are taken with beside the curve's own, so that clear segments have
/// one, too: that of their neighbours with a trace of opacity.
inline constexpr double kAddedExtinction = 1e-6;

/// (front scalar, back scalar, length) -> mean colour, and 1; otherwise as buildTable3d. Mean colours change little and
/// almost linearly with the length: so the size^3 entries lie 2 size along each scalar and size / 4, 2 at the least,
/// along the length. The entries of length 0 hold the limit for short segments.
Table3d buildMeanColors(const ExtinctionCurve& curve, int size, double maximumLength, const Progress& progress = {});

/// As rebuildTable3d (transfer/preintegration.h).
void rebuildMeanColors(Table3d& table, const ExtinctionCurve& before, const ExtinctionCurve& after);

/// (front scalar, back scalar) -> mean colour on one length, and mean extinction per local unit.
struct MeanTable2d {
  int size = 0;             ///< entries along each axis; entry i stands for i / (size - 1)
  double length = 0;        ///< that the colours are meant for, local units
  std::vector<float> rgba;  ///< entry (f, b) at (b * size + f) * 4
};

/// Builds every entry in double, rounded to float once, in parallel. size: 2 to 4096; length: > 0. Throws Error{input}
/// for others.
MeanTable2d buildMeanTable2d(const ExtinctionCurve& curve, int size, double length);

/// As rebuildTable3d.
void rebuildMeanTable2d(MeanTable2d& table, const ExtinctionCurve& before, const ExtinctionCurve& after);

}  // namespace havs
