// The paper's lookup: the pre-integrated table over (front scalar, back scalar, length), with half-texel scale and
// bias.
#include "lookup/filter.glsl"
uniform sampler3D table3d;
uniform float lengthScale;  // 1 / the length of the table's last entry

Rgba lookUp(Segment segment) {
  return fetchTable(table3d, vec3(segment.scalarFront, segment.scalarBack, min(segment.length * lengthScale, 1.0)));
}
