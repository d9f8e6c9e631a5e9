#pragma once
// The scalars of opacity 1 (per unit length), and where a segment first comes to one.
#include "core/limits.glsl"
#include "core/opaque.glsl"

UNIFORM(Texels, opaqueIntervals);  // two numbers an interval of the scalar: its ends
UNIFORM(Scalar, opaqueCount);

struct OpaqueHit {
  Real share;  // of the way along the segment; above 1: nowhere
  Real low;    // the interval that is met
  Real high;
};

OpaqueHit firstOpaque(Real scalarFront, Real scalarBack) {
  OpaqueHit first;
  first.share = Real(2.0);
  first.low = Real(0.0);
  first.high = Real(0.0);
  for (int i = 0; i < int(opaqueCount); ++i) {
    Real low = Real(scalarAt(opaqueIntervals, 2 * i));
    Real high = Real(scalarAt(opaqueIntervals, 2 * i + 1));
    Real entry = opaqueEntry(low, high, scalarFront, scalarBack);
    first.low = select(entry < first.share, low, first.low);
    first.high = select(entry < first.share, high, first.high);
    first.share = atMost(first.share, entry);
  }
  return first;
}
