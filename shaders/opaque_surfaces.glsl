// Opacity 1 (per unit length) is an opaque surface at the first scalar that reaches it: the segment ends there,
// whatever the lookup.
#include "core/opaque.glsl"
#include "curve.glsl"

uniform sampler2D opaqueIntervals;  // one texel an interval of the scalar: its two ends
uniform int opaqueCount;

Rgba lookUpToOpaque(Segment segment) {
  float nearest = 2.0;
  for (int i = 0; i < opaqueCount; ++i) {
    vec2 ends = texelFetch(opaqueIntervals, ivec2(i, 0), 0).rg;
    nearest = min(nearest, opaqueEntry(ends.x, ends.y, segment.scalarFront, segment.scalarBack));
  }
  bool hit = nearest <= 1.0;
  float part = hit ? nearest : 1.0;
  segment.scalarBack = mix(segment.scalarFront, segment.scalarBack, part);
  segment.length *= part;
  Rgba before = lookUp(segment);
  Rgba surface = Rgba(curveAt(segment.scalarBack).rgb, 1.0);
  return hit ? compositeUnder(before, surface) : before;
}
