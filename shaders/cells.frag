// Cells as they come (Shirley and Tuchman 1990 in spirit, by ray instead of by triangle): every face that rays enter a cell
// through draws the cell's segment, blended behind what is there. Faces arrive near first, in an order that is right for
// whole cells.
#include "core/language.glsl"
#include "payload.glsl"
#define HAVS_K 1
#include "core/kbuffer.glsl"
#include "core/compositing.glsl"
#include "segment_color.glsl"
#include "cells.glsl"

layout(location = 0) out vec4 colorTarget;

void main() {
  CellStretch stretch = stretchInCell();
  Segment segment;
  segment.scalarFront = stretch.entry.scalar;
  segment.scalarBack = stretch.exit.scalar;
#ifdef HAVS_CELL_DATA
  segment.scalarFront = gl_FrontFacing ? cellScalars.x : cellScalars.y;
#endif
  segment.length = max(stretch.exit.depth - stretch.entry.depth, 0.0) * stretch.rayLength;
  segment.visible = entersCell();
  colorTarget = segmentColor(segment);
}
