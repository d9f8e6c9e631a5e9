#pragma once
#include <array>
#include <vector>

#include "transfer/transfer_function.h"

namespace havs {

/// A transfer function as it is integrated: colour and extinction, both linear between knots, over the normalised
/// scalar s of [0, 1], extinction per unit of the local frame.
struct ExtinctionCurve {
  struct Knot {
    double s = 0;
    std::array<double, 3> color{0, 0, 0};
    double kappa = 0;
  };
  std::vector<Knot> knots;  ///< first at s = 0, last at s = 1, ascending; two at one s are a step
  /// Closed intervals of s where opacity is 1 under `perUnit`: an opaque surface at the first scalar of it that a ray
  /// reaches.
  std::vector<std::array<double, 2>> opaque;
  double unitLength = 0;               ///< used, in mesh units
  std::array<double, 2> domain{0, 1};  ///< used, in the data's unit
  double maximumKappa = 0;

  /// s of a data value: (value - domain[0]) / (domain[1] - domain[0]) clamped to [0, 1]; 0.5 when the domain is one
  /// value.
  double normalise(double value) const;
  /// Colour and kappa at s; at a step, the value of the upper side (s = 1: the last knot).
  Knot at(double s) const;
};

/// What is known of the mesh and the field when a transfer function is put to use.
struct CurveSetting {
  std::array<double, 2> fieldRange{0, 1};
  double boundingDiagonal = 2;  ///< mesh units
  double radius = 1;            ///< mesh units per local unit
  double tolerance = 1e-4;      ///< of the resampled kappa, relative to itself (perUnit between control points)
};

/// Piecewise-linear kappa; steps go kStepMargin (resolution.h) lower. Under perUnit opacity is at most 1 - 2^-24
/// outside `opaque`. Throws Error{input}: empty domain by request, unit length not positive, opaque at more than 256
/// places, more than 2^18 knots.
ExtinctionCurve makeCurve(const TransferFunction& function, const CurveSetting& setting);

/// The curve with its opaque intervals bridged by a straight line between what lies on either side: what segments that
/// end at an opaque surface see of it. Tables made from it are not smeared by the step up to the surface.
ExtinctionCurve withoutOpaque(const ExtinctionCurve& curve);

/// The same with the colours of the opaque intervals in them: what lies before an opaque surface, and the surface.
ExtinctionCurve withSurfaceColors(const ExtinctionCurve& curve);

}  // namespace havs
