// Opacity 1 (per unit length) is an opaque surface at the first scalar that reaches it: the segment ends there,
// whatever the lookup.
#include "core/opaque.glsl"
#include "curve.glsl"

uniform samplerBuffer opaqueIntervals;  // one texel an interval of the scalar: its two ends
uniform int opaqueCount;

// The colour of the surface met at `scalar`: taken a little inside of the interval, clear of a step at its end.
vec3 surfaceColor(float scalar, vec2 ends) {
  float inside = min(1e-6, 0.5 * (ends.y - ends.x));
  return curveAt(clamp(scalar, ends.x + inside, ends.y - inside)).rgb;
}

Rgba lookUpToOpaque(Segment segment) {
  float nearest = 2.0;
  vec2 met = vec2(0.0);
  for (int i = 0; i < opaqueCount; ++i) {
    vec2 ends = texelFetch(opaqueIntervals, i).rg;
    float entry = opaqueEntry(ends.x, ends.y, segment.scalarFront, segment.scalarBack);
    met = entry < nearest ? ends : met;
    nearest = min(nearest, entry);
  }
  bool hit = nearest <= 1.0;
  float part = hit ? nearest : 1.0;
  segment.scalarBack = mix(segment.scalarFront, segment.scalarBack, part);
  segment.length *= part;
  Rgba before = lookUp(segment);
  Rgba surface = Rgba(surfaceColor(segment.scalarBack, met), 1.0);
  return hit ? compositeUnder(before, surface) : before;
}
