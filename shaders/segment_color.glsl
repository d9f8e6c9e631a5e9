// The premultiplied colour of a segment: nothing where it is not visible; else the lookup's, cut at the first opaque
// surface.
#include "lookup.glsl"  // the lookup of the plan: a file of lookup/
#ifdef HAVS_OPAQUE_SURFACES
#include "opaque_surfaces.glsl"
#endif

Rgba segmentColor(Segment segment) {
  // Nothing to look up where nothing shows: a lookup with a loop is done with it at once.
  segment.length = segment.visible ? segment.length : 0.0;
  segment.scalarBack = segment.visible ? segment.scalarBack : segment.scalarFront;
#ifdef HAVS_CELL_DATA
  segment.scalarBack = segment.scalarFront;
#endif
#ifdef HAVS_OPAQUE_SURFACES
  Rgba color = lookUpToOpaque(segment);
#else
  Rgba color = lookUp(segment);
#endif
  return segment.visible ? color : Rgba(0.0);
}
