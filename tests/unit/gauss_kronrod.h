#pragma once
// Adaptive Gauss-Kronrod quadrature in long double: the oracle of the integration tests.
#include <array>
#include <cmath>

namespace havs::test {

/// The 15-point Kronrod rule over [a, b] (Piessens et al., QUADPACK, 1983).
template <class F>
long double kronrod15(const F& f, long double a, long double b) {
  constexpr std::array<long double, 8> kNodes{
      0.991455371120812639206854697526329L, 0.949107912342758524526189684047851L,
      0.864864423359769072789712788640926L, 0.741531185599394439863864773280788L,
      0.586087235467691130294144691838259L, 0.405845151377397166906606412076961L,
      0.207784955007898467600689403773245L, 0.0L};
  constexpr std::array<long double, 8> kWeights{
      0.022935322010529224963732008058970L, 0.063092092629978553290700663189204L, 0.104790010322250183839876322541518L,
      0.140653259715525918745189590510238L, 0.169004726639267902826583426598550L, 0.190350578064785409913256402421014L,
      0.204432940075298892414161999234649L, 0.209482141084727828012999174891714L};
  const long double middle = (a + b) / 2;
  const long double half = (b - a) / 2;
  long double sum = kWeights[7] * f(middle);
  for (int i = 0; i < 7; ++i) sum += kWeights[i] * (f(middle - half * kNodes[i]) + f(middle + half * kNodes[i]));
  return half * sum;
}

/// The integral of a positive f over [a, b] to a relative 1e-17: halves until whole and halves agree.
template <class F>
long double integrate(const F& f, long double a, long double b, int levels = 40) {
  const auto refine = [&](const auto& self, long double lo, long double hi, long double whole,
                          int left) -> long double {
    const long double middle = (lo + hi) / 2;
    const long double lower = kronrod15(f, lo, middle);
    const long double upper = kronrod15(f, middle, hi);
    if (left == 0 || std::fabs(lower + upper - whole) <= 1e-17L * std::fabs(whole)) return lower + upper;
    return self(self, lo, middle, lower, left - 1) + self(self, middle, hi, upper, left - 1);
  };
  return refine(refine, a, b, kronrod15(f, a, b), levels);
}

}  // namespace havs::test
