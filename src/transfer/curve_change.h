#pragma once
#include "transfer/extinction_curve.h"
#include "transfer/layer_builder.h"

namespace havs {

/// Which entries of a table of `lines` entries along the scalar differ between two curves: those whose closed range of
/// scalars meets the range in which the curves differ. That range is taken from the last knot that both have in common
/// at the beginning to the first in common at the end.
TouchedLines touchedLines(const ExtinctionCurve& before, const ExtinctionCurve& after, int lines);

}  // namespace havs
