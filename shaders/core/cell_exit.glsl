#pragma once
// Where a ray leaves a tetrahedron that it enters through the face of corners a, b, c. A point's weights (barycentric
// coordinates) change linearly along the ray; the first of them that comes to 0 is where the ray leaves. No neighbour is
// looked at, so cells can be drawn in any order.

#include "core/limits.glsl"

struct CellStretch {
  Real length;  // in the unit of the rates
  Real scalar;  // where the ray leaves
};

// `weight`: where the ray enters, each in [0, 1]; `rate`: by how much it changes along the ray per unit of length; the
// weight of the fourth corner is 0 there and only rises. A cell that no weight falls in (a flat one) has no length.
FUNCTION CellStretch stretchOf(Real weightA, Real weightB, Real weightC, Real rateA, Real rateB, Real rateC,
                               Real scalarFront, Real scalarRate, Real least, Real most) {
  Real far = Real(1.0e30);
  Real nearest = far;
  Real toA = weightA / (Real(0.0) - rateA);
  Real toB = weightB / (Real(0.0) - rateB);
  Real toC = weightC / (Real(0.0) - rateC);
  nearest = select(rateA < Real(0.0), toA, nearest);
  nearest = select((rateB < Real(0.0)) && (toB < nearest), toB, nearest);
  nearest = select((rateC < Real(0.0)) && (toC < nearest), toC, nearest);
  CellStretch stretch;
  stretch.length = select(nearest < far, nearest, Real(0.0));
  stretch.scalar = atMost(atLeast(scalarFront + stretch.length * scalarRate, least), most);
  return stretch;
}
