// The table over (front scalar, back scalar) at one length: mean colour and mean extinction, which is the same as
// colour and opacity with the opacity corrected to the actual length and the colour scaled along.
#include "core/exponential.glsl"
#include "core/integration.glsl"
#include "filter.glsl"
UNIFORM(Table2d, table2d);
UNIFORM(Scalar, mostExtinction);  // that 1 in the table stands for

Rgba lookUp(Segment segment) {
  Rgba mean = fetchTable(table2d, segment.scalarFront, segment.scalarBack);
  return layerOfDepth(mean, mean.a * Real(mostExtinction) * segment.length);
}
