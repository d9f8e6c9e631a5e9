#pragma once
// Opacity 1 (per unit length) is an opaque surface at the first scalar that reaches it: the segment ends there,
// whatever the lookup.
#include "curve.glsl"
#include "opaque_intervals.glsl"

CONSTANT Scalar kInside = Scalar(0.5 / 2097152.0);  // some steps of float, for rounded ends

// A segment that starts at `scalarFront` meets an interval there or at the end that is nearer. The colour is taken a
// little inside of it, clear of a step at its end. An interval of one number has no inside.
Rgba surfaceColor(Real scalarFront, OpaqueHit met) {
  Real reach = Real(0.5) * (met.high - met.low);
  Real least = met.low + atMost(reach, Real(kInside) * met.low);
  Real most = met.high - atMost(reach, Real(kInside) * met.high);
  Rgba surface = curveAt(atMost(atLeast(scalarFront, least), most));
  surface.a = Real(1.0);
  return selectColor(met.high > met.low, surface, met.color);
}

Rgba lookUpToOpaque(Segment segment) {
  OpaqueHit met = firstOpaque(segment.scalarFront, segment.scalarBack);
  Mask hit = met.share <= Real(1.0);
  Real part = select(hit, met.share, Real(1.0));
  Segment before = upTo(segment, part);
  Rgba color = lookUpInLight(before);
  Rgba surface = surfaceColor(segment.scalarFront, met);
  if (lit) {
    Real light = lightAt(segment, part);
    surface = Rgba(surface.r * light, surface.g * light, surface.b * light, surface.a);
  }
  return selectColor(hit, compositeUnder(color, surface), color);
}
