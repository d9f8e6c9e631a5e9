#pragma once
// exp and exp - 1 to the last bits, the same in every language: a GPU's own exp may be off by 3e-7, and 1 - exp(-x) of
// it loses every digit of a thin layer. exp(x) = 2^n exp(r) with |r| <= ln(2) / 2 (Cody and Waite 1980), exp(r) by its
// Taylor series.

CONSTANT Scalar kInverseFactorial[14] = {
    1.0, 1.0, 0.5, 0.1666666666666666667,
    0.04166666666666666667, 0.008333333333333333333, 0.001388888888888888889, 0.0001984126984126984127,
    0.00002480158730158730159, 2.755731922398589065e-6, 2.755731922398589065e-7, 2.505210838544171878e-8,
    2.087675698786809898e-9, 1.605904383682161460e-10};
CONSTANT int kExponentialTerms = kDouble ? 13 : 7;  // |r|^(terms + 1) / (terms + 1)! is below half an ulp
CONSTANT Scalar kLog2Head = Scalar(kDouble ? 6.93147180369123816490e-01 : 0.693145751953125);  // n * head is exact
CONSTANT Scalar kLog2Tail = Scalar(kDouble ? 1.90821492927058770002e-10 : 1.42860682030941723212e-6);
CONSTANT Scalar kInverseLog2 = Scalar(1.44269504088896340736);
CONSTANT Scalar kLowestExponent = Scalar(kDouble ? -708.0 : -87.0);  // below, exp is no normal number and given as 0

// exp(r) - 1 for |r| <= ln(2) / 2.
FUNCTION Real expm1Reduced(Real r) {
  Real p = Real(kInverseFactorial[kExponentialTerms]);
  for (int i = kExponentialTerms - 1; i >= 1; --i) p = p * r + Real(kInverseFactorial[i]);
  return p * r;
}

// x = n ln(2) + r for kLowestExponent <= x <= 0.
FUNCTION void reduceExponent(Real x, OUT(Real) n, OUT(Real) r) {
  n = roundToIntegral(x * Real(kInverseLog2));
  r = (x - n * Real(kLog2Head)) - n * Real(kLog2Tail);
}

// exp(x) - 1 for x <= 0.
FUNCTION Real expm1OfNegative(Real x) {
  Real n;
  Real r;
  reduceExponent(select(x > Real(kLowestExponent), x, Real(kLowestExponent)), n, r);
  Real scale = exp2Integral(n);
  return scale * expm1Reduced(r) + (scale - Real(1.0));
}

// exp(x) for x <= 0.
FUNCTION Real expOfNegative(Real x) {
  Real n;
  Real r;
  reduceExponent(select(x > Real(kLowestExponent), x, Real(kLowestExponent)), n, r);
  Real value = exp2Integral(n) * (Real(1.0) + expm1Reduced(r));
  return select(x < Real(kLowestExponent), Real(0.0), value);
}
