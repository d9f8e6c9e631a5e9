#pragma once
// Opacity 1 (per unit length) is an opaque surface at the first scalar that reaches it: the segment ends there,
// whatever the lookup.
#include "curve.glsl"
#include "opaque_intervals.glsl"

// The colour of the surface met at `scalar`: taken a little inside of its interval, clear of a step at its end. An
// interval of one number has no inside.
Rgba surfaceColor(Real scalar, OpaqueHit met) {
  Real inside = atMost(Real(0.5) * (met.high - met.low), Real(1.0e-6));
  Rgba surface = curveAt(atMost(atLeast(scalar, met.low + inside), met.high - inside));
  surface.a = Real(1.0);
  return selectColor(met.high > met.low, surface, met.color);
}

Rgba lookUpToOpaque(Segment segment) {
  OpaqueHit met = firstOpaque(segment.scalarFront, segment.scalarBack);
  Mask hit = met.share <= Real(1.0);
  Real part = select(hit, met.share, Real(1.0));
  Segment before = upTo(segment, part);
  Rgba color = lookUpInLight(before);
  Rgba surface = surfaceColor(before.scalarBack, met);
  if (lit) {
    Real light = lightAt(segment, part);
    surface = Rgba(surface.r * light, surface.g * light, surface.b * light, surface.a);
  }
  return selectColor(hit, compositeUnder(color, surface), color);
}
