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

const float kOpaque = 0.99;

// Of the colours `first` and `then`, one behind the other, leaves `first` when drawn behind them: `then` taken back.
// Something opaque cannot be.
Rgba takenBack(Rgba then) { return then.a < kOpaque ? then * (-1.0 / (1.0 - then.a)) : Rgba(0.0); }

void main() {
  CellStretch stretch = stretchInCell();
  // On faces seen edge-on a cell may seem to end before it begins: by rounding, or as the rasteriser's grid turns a sliver.
  // The stretches before and behind it overlap there by as much, so it is taken back once.
  bool backwards = stretch.exit.depth < stretch.entry.depth;
  Place front = stretch.entry, back = stretch.exit;
  if (backwards) {
    front = stretch.exit;
    back = stretch.entry;
  }
  Segment segment;
  segment.scalarFront = front.scalar;
  segment.scalarBack = back.scalar;
#ifdef HAVS_CELL_DATA
  segment.scalarFront = gl_FrontFacing ? cellScalars.x : cellScalars.y;
#endif
  segment.length = (back.depth - front.depth) * stretch.rayLength;
  segment.visible = entersCell();
  Rgba color = segmentColor(segment);
  colorTarget = backwards ? takenBack(color) : color;
}
