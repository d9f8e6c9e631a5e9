// The premultiplied colour of a segment: nothing where it is not visible; else the lookup's, cut at isosurfaces and at the
// first opaque surface.
#include "core/compositing.glsl"
#include "lookup.glsl"  // the lookup of the plan: a file of lookup/, or of measure/
#ifdef HAVS_LIT
#include "lit.glsl"
#else
Rgba lookUpLit(Segment segment) { return lookUp(segment); }
Real lightAt(Segment segment, Real share) { return Real(1.0); }
Payload payloadAt(Segment segment, Real share) { return segment.back; }
#endif

// The segment up to `part` of its way.
Segment upTo(Segment segment, Real part) {
  Segment first = segment;
  first.scalarBack = (Real(1.0) - part) * segment.scalarFront + part * segment.scalarBack;
  first.length = segment.length * part;
  if (lit) first.back = payloadAt(segment, part);
  return first;
}

Rgba lookUpInLight(Segment segment) {
  if (lit) return lookUpLit(segment);
  return lookUp(segment);
}

#if defined(HAVS_OPAQUE_SURFACES) && !defined(HAVS_MEASURES_SURFACES)
#include "opaque_surfaces.glsl"
#else
Rgba lookUpToOpaque(Segment segment) { return lookUpInLight(segment); }
#endif

Rgba lookUpVolume(Segment segment) {
  Rgba color;
  if (opaqueSurfaces) {
    color = lookUpToOpaque(segment);
  } else {
    color = lookUpInLight(segment);
  }
  return color;
}

#ifdef HAVS_ISOSURFACES
#include "isosurfaces.glsl"
#else
Rgba lookUpWithIsosurfaces(Segment segment) { return lookUpVolume(segment); }
#endif

Rgba segmentColor(Segment segment) {
  // Nothing to look up where nothing shows: a lookup with a loop is done with it at once.
  segment.length = select(segment.visible, segment.length, Real(0.0));
  segment.scalarBack = select(segment.visible, segment.scalarBack, segment.scalarFront);
  if (cellData) {
    if (!lit) segment.back = segment.front;  // light belongs to the points, whatever the scalar does
    segment.scalarBack = segment.scalarFront;
  }
  Rgba color;
  if (isosurfaces) {
    color = lookUpWithIsosurfaces(segment);
  } else {
    color = lookUpVolume(segment);
  }
  Rgba nothing = Rgba(Real(0.0), Real(0.0), Real(0.0), Real(0.0));
  return selectColor(segment.visible, color, nothing);
}
