#pragma once
// Where a ray leaves a tetrahedron that it enters through the face of corners a, b, c. A point's weights (barycentric
// coordinates) change linearly along the ray; the first of them that comes to 0 is where the ray leaves. No neighbour is
// looked at, so cells can be drawn in any order.

#include "core/limits.glsl"

struct CellStretch {
  Real length;  // in the unit of the rates
  Real scalar;  // where the ray leaves
};

// `weight`: where the ray enters, each in [0, sum], together `sum`; `rate`: by how much it changes along the ray per unit
// of length, for a sum of 1; the weight of the fourth corner is 0 there and only rises. A cell that no weight falls in (a
// flat one) has no length. One division: ways to the faces are compared as fractions.
FUNCTION CellStretch stretchOf(Real weightA, Real weightB, Real weightC, Real perSum, Real rateA, Real rateB,
                               Real rateC, Real scalarFront, Real scalarRate, Real least, Real most) {
  Real zero = Real(0.0);
  Real fallA = zero - rateA;
  Real fallB = zero - rateB;
  Real fallC = zero - rateC;
  Mask meetsA = fallA > zero;
  Real over = select(meetsA, weightA, Real(1.0));
  Real under = select(meetsA, fallA, zero);
  Mask meetsB = (fallB > zero) && (weightB * under < over * fallB);
  over = select(meetsB, weightB, over);
  under = select(meetsB, fallB, under);
  Mask meetsC = (fallC > zero) && (weightC * under < over * fallC);
  over = select(meetsC, weightC, over);
  under = select(meetsC, fallC, under);
  Mask meets = under > zero;
  CellStretch stretch;
  stretch.length = select(meets, over * perSum / select(meets, under, Real(1.0)), zero);
  stretch.scalar = atMost(atLeast(scalarFront + stretch.length * scalarRate, least), most);
  return stretch;
}
