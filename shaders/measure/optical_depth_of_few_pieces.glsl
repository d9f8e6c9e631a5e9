// X-ray: the optical depth of a segment, in the fourth number, where the transfer function has few pieces
// (transfer/few_pieces.h), lookupNumber of them: the segment's part in each, times extinction in its middle.
#include "core/exponential.glsl"
#include "core/integration.glsl"
#include "core/limits.glsl"
#include "opaque_depth.glsl"
UNIFORM_NUMBERS(pieceEnds, 8);
UNIFORM_NUMBERS(pieceAtZero, 8);
UNIFORM_NUMBERS(pieceHalfSlope, 8);
CONSTANT Scalar kLeastExtent = Scalar(1.1920929e-7);  // 2^-23: of one scalar the mean is that of so much above it

Rgba lookUp(Segment segment) {
  Mask rises = segment.scalarBack > segment.scalarFront;
  Real low = select(rises, segment.scalarFront, segment.scalarBack);
  Real high = atLeast(select(rises, segment.scalarBack, segment.scalarFront), low + Real(kLeastExtent));
  Real from = low;
  Real sum = Real(0.0);
  for (int i = 0; i < lookupNumber; ++i) {
    Real to = atMost(atLeast(Real(pieceEnds[i]), low), high);
    sum = sum + (to - from) * (Real(pieceAtZero[i]) + Real(pieceHalfSlope[i]) * (from + to));
    from = to;
  }
  Real depth = atLeast(sum / (high - low), Real(0.0)) * segment.length;
  if (opaqueSurfaces) depth = depth + depthOfSurface(segment);
  return Rgba(Real(0.0), Real(0.0), Real(0.0), depth);
}
