#pragma once
// The fetch functions of core/curve.glsl and core/integral_functions.glsl: the packed curve
// (src/transfer/packed_curve.h) as texels.
UNIFORM(Texels, curvePieces);
UNIFORM(Texels, curveGuide);
UNIFORM(Texels, curveIntegrals);
UNIFORM(Scalar, guideCells);

Real pieceNear(Real s) {
  Real cell = s * Real(guideCells);
  Real last = Real(guideCells - Scalar(1.0));
  return numberAt(curveGuide, toInt(select(cell < last, cell, last)));
}
Rgba piecePlace(Real piece) { return rgbaAt(curvePieces, 3 * toInt(piece)); }
Rgba pieceLow(Real piece) { return rgbaAt(curvePieces, 3 * toInt(piece) + 1); }
Rgba pieceHigh(Real piece) { return rgbaAt(curvePieces, 3 * toInt(piece) + 2); }
Rgba pieceExtinction(Real piece) { return rgbaAt(curveIntegrals, 3 * toInt(piece)); }
Rgba lightHead(Real piece) { return rgbaAt(curveIntegrals, 3 * toInt(piece) + 1); }
Rgba lightTail(Real piece) { return rgbaAt(curveIntegrals, 3 * toInt(piece) + 2); }

#include "core/curve.glsl"
