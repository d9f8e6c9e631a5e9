// Cells in any order: every face that rays enter a cell through gives the measure of the cell's segment, which blending
// adds to the pixel.
#include "core/language.glsl"
#include "payload.glsl"
#include "core/segment.glsl"
#include "core/limits.glsl"
#include "core/cell_exit.glsl"
#include "segment_color.glsl"

smooth in vec3 weights;
smooth in float scalar;
flat in vec3 cornerScalars;
flat in vec4 frontA, frontB, frontC;
flat in vec4 backA, backB, backC;
flat in float hasBack;
#ifdef HAVS_CELL_DATA
flat in vec2 cellScalars;
#endif
uniform vec4 pixelToRay;  // xy scale and zw offset from window coordinates to the ray's slope; zero for parallel rays

layout(location = 0) out vec4 sums;

Segment segmentOfCell() {
  vec4 a = gl_FrontFacing ? frontA : backA;
  vec4 b = gl_FrontFacing ? frontB : backB;
  vec4 c = gl_FrontFacing ? frontC : backC;
  vec3 along = vec3(gl_FragCoord.xy * pixelToRay.xy + pixelToRay.zw, 1.0);
  vec3 rates = vec3(dot(a.xyz, along), dot(b.xyz, along), dot(c.xyz, along));
  vec3 weight = clamp(weights, 0.0, 1.0);
  float least = min(min(cornerScalars.x, cornerScalars.y), min(cornerScalars.z, a.w));
  float most = max(max(cornerScalars.x, cornerScalars.y), max(cornerScalars.z, a.w));
  Segment segment;
  segment.scalarFront = clamp(scalar, 0.0, 1.0);
  CellStretch stretch = stretchOf(weight.x, weight.y, weight.z, 1.0, rates.x, rates.y, rates.z, segment.scalarFront,
                                  dot(rates, cornerScalars - a.w), least, most);
  segment.scalarBack = stretch.scalar;
  segment.length = stretch.length * length(along);
#ifdef HAVS_CELL_DATA
  segment.scalarFront = gl_FrontFacing ? cellScalars.x : cellScalars.y;
#endif
  segment.visible = gl_FrontFacing || hasBack > 0.5;
  return segment;
}

void main() { sums = segmentColor(segmentOfCell()); }
