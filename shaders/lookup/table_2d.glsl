// The table over (front scalar, back scalar) at one length: mean colour and mean extinction, which is the same as
// colour and opacity with the opacity corrected to the actual length and the colour scaled along.
#include "core/exponential.glsl"
#include "core/integration.glsl"
#include "lookup/filter.glsl"
uniform sampler2D table2d;
uniform float mostExtinction;  // that 1 in the table stands for

Rgba lookUp(Segment segment) {
  vec4 mean = fetchTable(table2d, vec2(segment.scalarFront, segment.scalarBack));
  return layerOfDepth(mean, mean.a * mostExtinction * segment.length);
}
