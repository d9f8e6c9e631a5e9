#pragma once
// Riemann sums over a segment: the transfer function at the middles of equal steps (core/curve.glsl), each step of one
// colour and extinction.

// The scalar in the middle of step i.
FUNCTION Real middleOfStep(Real scalarFront, Real scalarBack, int i, int steps) {
  Real share = (Real(Scalar(i)) + Real(0.5)) / Real(Scalar(steps));
  return (Real(1.0) - share) * scalarFront + share * scalarBack;
}

// The opacity of a step is corrected for its length: 1 - exp(-kappa h).
TABLE_FUNCTION Rgba riemannSegment(TABLES Real scalarFront, Real scalarBack, Real length, int steps) {
  Real h = length / Real(Scalar(steps));
  Rgba sum = Rgba(Real(0.0), Real(0.0), Real(0.0), Real(0.0));
  for (int i = 0; i < steps; ++i) {
    Rgba middle = curveAt(WITH_TABLES middleOfStep(scalarFront, scalarBack, i, steps));
    sum = compositeUnder(sum, layerOfDepth(middle, middle.a * h));
  }
  return sum;
}

// The opacity of a step is kappa h, at most 1.
TABLE_FUNCTION Rgba riemannLinearSegment(TABLES Real scalarFront, Real scalarBack, Real length, int steps) {
  Real h = length / Real(Scalar(steps));
  Rgba sum = Rgba(Real(0.0), Real(0.0), Real(0.0), Real(0.0));
  for (int i = 0; i < steps; ++i) {
    Rgba middle = curveAt(WITH_TABLES middleOfStep(scalarFront, scalarBack, i, steps));
    Real alpha = atMost(middle.a * h, Real(1.0));
    sum = compositeUnder(sum, Rgba(middle.r * alpha, middle.g * alpha, middle.b * alpha, alpha));
  }
  return sum;
}
