#pragma once
// The scalars of opacity 1 (per unit length), and where a segment first comes to one.
#include "core/limits.glsl"
#include "core/opaque.glsl"

UNIFORM(Texels, opaqueIntervals);  // five numbers an interval of the scalar: its ends, and the colour of one in it
UNIFORM(Scalar, opaqueCount);

struct OpaqueHit {
  Real share;  // of the way along the segment; above 1: nowhere
  Real low;    // the interval that is met
  Real high;
  Rgba color;
};

OpaqueHit firstOpaque(Real scalarFront, Real scalarBack) {
  OpaqueHit first;
  first.share = Real(2.0);
  first.low = Real(0.0);
  first.high = Real(0.0);
  first.color = Rgba(Real(0.0), Real(0.0), Real(0.0), Real(1.0));
  for (int i = 0; i < int(opaqueCount); ++i) {
    Real low = Real(scalarAt(opaqueIntervals, 5 * i));
    Real high = Real(scalarAt(opaqueIntervals, 5 * i + 1));
    Real entry = opaqueEntry(low, high, scalarFront, scalarBack);
    Mask nearer = entry < first.share;
    first.low = select(nearer, low, first.low);
    first.high = select(nearer, high, first.high);
    first.color.r = select(nearer, Real(scalarAt(opaqueIntervals, 5 * i + 2)), first.color.r);
    first.color.g = select(nearer, Real(scalarAt(opaqueIntervals, 5 * i + 3)), first.color.g);
    first.color.b = select(nearer, Real(scalarAt(opaqueIntervals, 5 * i + 4)), first.color.b);
    first.share = atMost(first.share, entry);
  }
  return first;
}
