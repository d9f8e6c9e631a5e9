// Cells in any order: every face that rays enter a cell through gives the measure of the cell's segment, which blending
// adds to the pixel.
#include "core/language.glsl"
#include "payload.glsl"
#include "core/segment.glsl"
#include "core/limits.glsl"
#include "core/cell_exit.glsl"
#include "segment_color.glsl"

smooth in vec2 weights;
smooth in float scalar;
flat in vec3 gradientA, gradientB, gradientC, scalarGradient;
flat in vec2 scalarRange;
#ifdef HAVS_CELL_DATA
flat in float cellScalar;
#endif
uniform vec4 pixelToRay;  // xy scale and zw offset from window coordinates to the ray's slope; zero for parallel rays

layout(location = 0) out vec4 sums;

Segment segmentOfCell() {
  vec3 along = vec3(gl_FragCoord.xy * pixelToRay.xy + pixelToRay.zw, 1.0);
  Segment segment;
  segment.scalarFront = clamp(scalar, 0.0, 1.0);
  CellStretch stretch = stretchOf(weights.x, weights.y, 1.0 - weights.x - weights.y, 1.0, dot(gradientA, along),
                                  dot(gradientB, along), dot(gradientC, along), segment.scalarFront,
                                  dot(scalarGradient, along), scalarRange.x, scalarRange.y);
  segment.scalarBack = stretch.scalar;
  segment.length = atLeast(stretch.length, 0.0) * length(along);  // a weight may be below 0 by its rounding
#ifdef HAVS_CELL_DATA
  segment.scalarFront = cellScalar;
#endif
  segment.visible = true;
  return segment;
}

void main() { sums = segmentColor(segmentOfCell()); }
