// The order certificate of cells: a segment is misordered when it begins nearer, by more than the tolerance, than one that
// was drawn before. The target holds where the farthest segment so far begins, the number of misordered ones, and of all.
#include "core/language.glsl"
#include "payload.glsl"
#define HAVS_K 1
#include "core/kbuffer.glsl"
#include "cells.glsl"

layout(location = 0) inout vec4 seen;

void main() {
  CellStretch stretch = stretchInCell();
  float begin = stretch.entry.depth * stretch.rayLength;
  if (!entersCell()) discard;
  bool misordered = begin < seen.x - kLateTolerance;
  seen = vec4(max(seen.x, begin), seen.y + (misordered ? 1.0 : 0.0), seen.z + 1.0, 0.0);
}
