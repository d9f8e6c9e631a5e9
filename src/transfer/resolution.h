#pragma once
#include "transfer/extinction_curve.h"

namespace havs {

/// Steps of a transfer function lie lower by this part of their scalar than asked for. That is what float may be off by
/// in a scalar, also one interpolated over a face (some 2^-24 of itself), and more: so data that have the very value of
/// a step (labels) are on its upper side on every device, as in double.
inline constexpr double kStepMargin = 0x1p-21;

/// Whether what is drawn at a data value, whose scalar is a float of [0, 1] over the curve's domain, is what the
/// function says of it, to 1/256 in colour and of its greatest opacity. A function in the data's unit may change
/// within so small a part of the domain that float, or double, does not tell.
bool holdsInFloat(const TransferFunction& function, const ExtinctionCurve& curve, double value);

}  // namespace havs
