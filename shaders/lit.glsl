#pragma once
// Light along a segment. Its two ends carry the light that falls on them and the share of the extinction that the
// modulation by the gradient leaves; both go linearly from one end to the other.
#include "core/lighting.glsl"

// The lookup's colour under the segment's light: what comes from the front and from the back each has the light there.
Rgba lookUpLit(Segment segment) {
  segment.length = segment.length * (Real(0.5) * (densityOf(segment.front) + densityOf(segment.back)));
  Rgba color = lookUp(segment);
  Real front = frontShare(color.a);
  Real light = front * lightOf(segment.front) + (Real(1.0) - front) * lightOf(segment.back);
  return Rgba(color.r * light, color.g * light, color.b * light, color.a);
}

// The light where `share` of the segment's way is gone.
Real lightAt(Segment segment, Real share) {
  return (Real(1.0) - share) * lightOf(segment.front) + share * lightOf(segment.back);
}

// What the segment carries there.
Payload payloadAt(Segment segment, Real share) {
  Real density = (Real(1.0) - share) * densityOf(segment.front) + share * densityOf(segment.back);
  return makeLight(lightAt(segment, share), density);
}
