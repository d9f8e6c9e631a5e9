// No table of colours: the segment is cut at the knots of the transfer function and integrated piece by piece.
#include "curve.glsl"
#include "core/exponential.glsl"
#include "core/integration.glsl"
#include "core/exact.glsl"

Rgba lookUp(Segment segment) { return exactSegment(segment.scalarFront, segment.scalarBack, segment.length); }

// About how many turns more than one a segment takes: the native device has lanes of equal work go together.
Real workOf(Segment segment) { return absolute(pieceNear(segment.scalarBack) - pieceNear(segment.scalarFront)); }

#ifdef HAVS_LIT
#include "core/exact_lit.glsl"
#define HAVS_LIGHTS_PIECES

Rgba lookUpPiecesInLight(Segment segment) {
  LightAlong along;
  along.front = lightOf(segment.front);
  along.back = lightOf(segment.back);
  along.densityFront = densityOf(segment.front);
  along.densityBack = densityOf(segment.back);
  return exactSegmentInLight(segment.scalarFront, segment.scalarBack, segment.length, along);
}
#endif
