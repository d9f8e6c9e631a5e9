#pragma once
// Opacity 1 (per unit length) is an opaque surface at the first scalar that reaches it: the segment ends there,
// whatever the lookup.
#include "core/limits.glsl"
#include "core/opaque.glsl"
#include "curve.glsl"

UNIFORM(Texels, opaqueIntervals);  // two numbers an interval of the scalar: its ends
UNIFORM(Scalar, opaqueCount);

// The colour of the surface met at `scalar`, of the interval from `low` to `high`: taken a little inside, clear of a
// step at its end.
Rgba surfaceColor(Real scalar, Real low, Real high) {
  Real inside = atMost(Real(0.5) * (high - low), Real(1.0e-6));
  Rgba surface = curveAt(atMost(atLeast(scalar, low + inside), high - inside));
  surface.a = Real(1.0);
  return surface;
}

Rgba lookUpToOpaque(Segment segment) {
  Real nearest = Real(2.0);
  Real metLow = Real(0.0);
  Real metHigh = Real(0.0);
  for (int i = 0; i < int(opaqueCount); ++i) {
    Real low = Real(scalarAt(opaqueIntervals, 2 * i));
    Real high = Real(scalarAt(opaqueIntervals, 2 * i + 1));
    Real entry = opaqueEntry(low, high, segment.scalarFront, segment.scalarBack);
    metLow = select(entry < nearest, low, metLow);
    metHigh = select(entry < nearest, high, metHigh);
    nearest = atMost(nearest, entry);
  }
  Mask hit = nearest <= Real(1.0);
  Real part = select(hit, nearest, Real(1.0));
  segment.scalarBack = (Real(1.0) - part) * segment.scalarFront + part * segment.scalarBack;
  segment.length = segment.length * part;
  Rgba before = lookUp(segment);
  Rgba surface = surfaceColor(segment.scalarBack, metLow, metHigh);
  return selectColor(hit, compositeUnder(before, surface), before);
}
