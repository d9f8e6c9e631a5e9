#pragma once
// The phase function of Henyey and Greenstein 1941, Diffuse Radiation in the Galaxy. g is its mean cosine, -1 < g < 1;
// positive: forwards. All forms are free of cancellation, g = 0 included.
#include <cmath>
#include <numbers>

namespace havs {

namespace detail {
/// sqrt(1 + g^2 - 2 g cosine).
inline double phaseDistance(double g, double cosine) {
  const double a = std::abs(g);
  return std::sqrt((1 - a) * (1 - a) + 2 * (a - g * cosine));
}
}  // namespace detail

/// Density per steradian of the direction at an angle of this cosine to the old one.
inline double henyeyGreenstein(double g, double cosine) {
  const double t = detail::phaseDistance(g, cosine);
  return (1 - g) * (1 + g) / (4 * std::numbers::pi * t * t * t);
}

/// The share of light that goes at angles of at most this cosine, 0 to 1.
inline double henyeyGreensteinShare(double g, double cosine) {
  const double t = detail::phaseDistance(g, cosine);
  return (1 - g) * (1 + cosine) / (t * (1 + g + t));
}

/// The cosine of that share: with shares that are evenly spread, a sample of the phase function.
inline double henyeyGreensteinCosine(double g, double share) {
  const double c = 1 - g + 2 * g * share;
  const double t = (1 - g) * (1 + g) / c;
  return std::fmin(1, (1 + g) * share / c * (1 + g + t) - 1);
}

}  // namespace havs
