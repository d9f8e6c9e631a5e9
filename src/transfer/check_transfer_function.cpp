#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "transfer/transfer_files.h"

namespace havs {

void checkTransferFunction(const TransferFunction& function, const std::string& where) {
  if (function.points.empty()) failInput("a transfer function needs at least one control point", where);
  if (function.unitLength && !(*function.unitLength > 0 && std::isfinite(*function.unitLength))) {
    failInput(fmt::format("unit_length {} is not positive", *function.unitLength), where);
  }
  if (function.domain) {
    const auto& [low, high] = *function.domain;
    if (!(low < high && std::isfinite(low) && std::isfinite(high))) {
      failInput(fmt::format("domain [{}, {}] is empty", low, high), where, "give the smaller value first");
    }
  }
  const double highest = function.meaning == OpacityMeaning::perUnit ? 1.0 : HUGE_VAL;
  for (std::size_t i = 0; i < function.points.size(); ++i) {
    const ControlPoint& p = function.points[i];
    const std::string place = fmt::format("{}, point {}", where, i + 1);
    if (!std::isfinite(p.scalar)) failInput(fmt::format("scalar {} is not finite", p.scalar), place);
    if (function.normalised && !(p.scalar >= 0 && p.scalar <= 1)) {
      failInput(fmt::format("scalar {} is outside [0, 1]", p.scalar), place,
                R"(values in the data's unit need "scale": "data")");
    }
    for (double c : p.color) {
      if (!(c >= 0 && c <= 1)) failInput(fmt::format("colour {} is outside [0, 1]", c), place);
    }
    if (!(p.opacity >= 0 && p.opacity <= highest && std::isfinite(p.opacity))) {
      failInput(fmt::format("opacity {} is outside [0, {}]", p.opacity, highest), place,
                highest == 1 ? R"("opacity": "extinction" allows more than 1)" : "");
    }
    if (i > 0 && p.scalar < function.points[i - 1].scalar) {
      failInput(fmt::format("scalar {} comes after {}", p.scalar, function.points[i - 1].scalar), place,
                "sort the points by scalar");
    }
    if (i > 1 && p.scalar == function.points[i - 2].scalar) {
      failInput(fmt::format("scalar {} is given a third time", p.scalar), place,
                "two points at one scalar make a step");
    }
  }
}

}  // namespace havs
