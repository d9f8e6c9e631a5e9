#pragma once
#include <cmath>

#include "fuzz/fuzz.h"
#include "transfer/extinction_curve.h"
#include "transfer/transfer_files.h"

namespace havs::fuzz {

/// The target of all kinds of transfer functions: one that is read keeps its promises, and so does the curve made of
/// it.
inline int readTransferFunction(const std::filesystem::path& file) {
  readOrRefuse([&] {
    const TransferFunction function = loadTransferFunction(file.string());
    try {
      checkTransferFunction(function, "");
    } catch (const Error& error) {
      require(false, error.what());
    }
    const ExtinctionCurve curve = makeCurve(function, {.fieldRange = {-1, 3}});
    require(curve.knots.size() >= 2 && curve.knots.front().s == 0 && curve.knots.back().s == 1, "the curve is whole");
    for (std::size_t i = 0; i < curve.knots.size(); ++i) {
      const auto& [s, color, kappa] = curve.knots[i];
      require(i == 0 || s >= curve.knots[i - 1].s, "knots ascend");
      require(std::isfinite(kappa) && kappa >= 0, "extinction is finite and not negative");
      for (const double c : color) require(c >= 0 && c <= 1, "colours lie in [0, 1]");
    }
  });
  return 0;
}

}  // namespace havs::fuzz
