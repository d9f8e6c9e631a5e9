#pragma once
// Where a segment first meets a closed interval [low, high] of the scalar, as a fraction of its way; 2 where it does
// not.
FUNCTION Real opaqueEntry(Real low, Real high, Real scalarFront, Real scalarBack) {
  Mask startsInside = (scalarFront >= low) && (scalarFront <= high);
  Mask rises = (scalarFront < low) && (scalarBack >= low);
  Mask falls = (scalarFront > high) && (scalarBack <= high);
  Real bound = select(rises, low, high);
  Real difference = scalarBack - scalarFront;
  Real way = (bound - scalarFront) / select(rises || falls, difference, Real(1.0));
  return select(startsInside, Real(0.0), select(rises || falls, way, Real(2.0)));
}
