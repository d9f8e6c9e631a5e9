// The order certificate of cells: a segment is misordered when it begins nearer, by more than the tolerance, than the last
// one that was in order ended. Cells do not overlap, so that is to begin nearer than one that is drawn already. As a cell
// begins where the one before it ended, bit for bit, rounding on faces seen edge-on counts nothing.
// The target holds where the last segment in order ended, the number of misordered segments, and that of all.
#include "core/language.glsl"
#include "payload.glsl"
#define HAVS_K 1
#include "core/kbuffer.glsl"
#include "cells.glsl"

layout(location = 0) inout vec4 seen;

void main() {
  CellStretch stretch = stretchInCell();
  if (!entersCell()) discard;
  bool misordered = stretch.entry.depth * stretch.rayLength < seen.x - kLateTolerance;
  float end = stretch.exit.depth * stretch.rayLength;
  seen = vec4(misordered ? seen.x : end, seen.y + (misordered ? 1.0 : 0.0), seen.z + 1.0, 0.0);
}
