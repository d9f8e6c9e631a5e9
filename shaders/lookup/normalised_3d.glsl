// Mean colours over (front scalar, back scalar, length) in a table, smooth enough for a small one; the opacity by the
// integral function of the extinction, exactly.
#include "curve.glsl"
#include "core/exponential.glsl"
#include "core/integration.glsl"
#include "core/integral_functions.glsl"
#include "filter.glsl"
UNIFORM(Table3d, table3d);
UNIFORM(Scalar, lengthScale);  // 1 / the length of the table's last entry

Rgba lookUp(Segment segment) {
  Real length = atMost(segment.length * Real(lengthScale), Real(1.0));
  Real extinction = meanExtinction(coverageOf(segment.scalarFront, segment.scalarBack));
  return layerOfDepth(fetchTable(table3d, segment.scalarFront, segment.scalarBack, length),
                      extinction * segment.length);
}
