#pragma once
#include <string>

#include "transfer/extinction_curve.h"
#include "transfer/transfer_function.h"

namespace havs {

inline ExtinctionCurve presetCurve(const std::string& name) { return makeCurve(loadTransferFunction(name), {}); }

}  // namespace havs
