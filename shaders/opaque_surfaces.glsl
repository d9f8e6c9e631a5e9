#pragma once
// Opacity 1 (per unit length) is an opaque surface at the first scalar that reaches it: the segment ends there,
// whatever the lookup.
#include "curve.glsl"
#include "opaque_intervals.glsl"

// The colour of the surface met at `scalar`, of the interval from `low` to `high`: taken a little inside, clear of a
// step at its end.
Rgba surfaceColor(Real scalar, Real low, Real high) {
  Real inside = atMost(Real(0.5) * (high - low), Real(1.0e-6));
  Rgba surface = curveAt(atMost(atLeast(scalar, low + inside), high - inside));
  surface.a = Real(1.0);
  return surface;
}

Rgba lookUpToOpaque(Segment segment) {
  OpaqueHit met = firstOpaque(segment.scalarFront, segment.scalarBack);
  Mask hit = met.share <= Real(1.0);
  Real part = select(hit, met.share, Real(1.0));
  Segment before = upTo(segment, part);
  Rgba color = lookUpInLight(before);
  Rgba surface = surfaceColor(before.scalarBack, met.low, met.high);
  if (lit) {
    Real light = lightAt(segment, part);
    surface = Rgba(surface.r * light, surface.g * light, surface.b * light, surface.a);
  }
  return selectColor(hit, compositeUnder(color, surface), color);
}
