#pragma once
#include "transfer/extinction_curve.h"

namespace havs {

/// Whether what is drawn at a data value, whose scalar is a float of [0, 1] over the curve's domain, is what the
/// function says of it, to 1/256 in colour and of its greatest opacity. A function in the data's unit may change
/// within so small a part of the domain that float, or double, does not tell.
bool holdsInFloat(const TransferFunction& function, const ExtinctionCurve& curve, double value);

}  // namespace havs
