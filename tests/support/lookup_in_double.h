#pragma once
// What each row of lookups() computes, in double over the very tables, and how far float may be from it: the oracle of
// every device.
#include "render/lookups.h"
#include "unit/transfer/lookup_functions.h"

namespace havs::test {

struct LookupSetting {
  const ExtinctionCurve& curve;
  double longest;      ///< segment of the table, local units
  double tableLength;  ///< of the 2D table
  int tableSize;
};

inline LookupFunction inDouble(const Lookup& row, const LookupSetting& s) {
  if (row.name == "post") return postLookup(s.curve);
  if (row.name == "integral") return integralLookup(s.curve);
  if (row.name == "2d") return table2dLookup(s.curve, s.tableSize, s.tableLength);
  if (row.name == "3d") return table3dLookup(s.curve, s.tableSize, s.longest);
  if (row.name == "3d-normalised") return normalisedLookup(s.curve, s.tableSize, s.longest);
  if (row.name.starts_with("riemann:")) return riemannLookup(s.curve, row.number);
  if (row.name.starts_with("riemann-linear:")) return riemannLinearLookup(s.curve, row.number);
  return [&s](double f, double b, double length) { return exactly(s.curve, f, b, length); };
}

inline constexpr double kLookupFloat = 1e-6;

/// What float may be off by for segments up to `longest`. Samples between the ends lie on scalars rounded to 2^-24,
/// which a steep curve magnifies; places in a table are rounded to 2^-24 of its size along each axis, and neighbours
/// differ by at most 1.
inline double floatBoundOf(const Lookup& row, const LookupSetting& s) {
  if (tableOf(row)) return kLookupFloat + 3 * 2 * s.tableSize * 0x1p-24;
  if (row.number == 0) return kLookupFloat;
  double steepest = 0;
  for (std::size_t i = 1; i < s.curve.knots.size(); ++i) {
    const auto &a = s.curve.knots[i - 1], &b = s.curve.knots[i];
    if (b.s > a.s) steepest = std::max(steepest, std::abs(b.kappa - a.kappa) / (b.s - a.s));
  }
  return kLookupFloat + steepest * s.longest * 0x1p-24;
}

/// Half a step of each table format, of numbers from 0 to 1.
inline double halfStepOf(const TableFormat& format) {
  if (format.name == "rgba32f") return 0;
  if (format.name == "rgba16f") return 0x1p-12;
  return 0.5 / (format.name == "rgba16" ? 65535 : 255);
}

}  // namespace havs::test
