// Mean colours over (front scalar, back scalar, length) in a table, smooth enough for a small one; the opacity by the
// integral function of the extinction, exactly.
#include "curve.glsl"
#include "core/exponential.glsl"
#include "core/integration.glsl"
#include "core/integral_functions.glsl"
#include "lookup/filter.glsl"
uniform sampler3D table3d;
uniform float lengthScale;  // 1 / the length of the table's last entry

Rgba lookUp(Segment segment) {
  vec3 place = vec3(segment.scalarFront, segment.scalarBack, min(segment.length * lengthScale, 1.0));
  float extinction = meanExtinction(coverageOf(segment.scalarFront, segment.scalarBack));
  return layerOfDepth(fetchTable(table3d, place), extinction * segment.length);
}
