// The paper's lookup: the pre-integrated table over (front scalar, back scalar, length), with half-texel scale and
// bias.
#include "core/limits.glsl"
#include "filter.glsl"
UNIFORM(Table3d, table3d);
UNIFORM(Scalar, lengthScale);  // 1 / the length of the table's last entry

Rgba lookUp(Segment segment) {
  Real length = atMost(segment.length * Real(lengthScale), Real(1.0));
  return fetchTable(table3d, segment.scalarFront, segment.scalarBack, length);
}
