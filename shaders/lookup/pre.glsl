// Pre-classification: colour and extinction were looked up at the vertices, and both are linear along the segment: what
// projected tetrahedra do (Shirley, Tuchman 1990). The integral of that is exact.
#include "core/exponential.glsl"
#include "core/integration.glsl"

UNIFORM(Scalar, mostExtinction);  // per local unit; what fragments carry is a fraction of it

Rgba lookUp(Segment segment) {
  Rgba front = colorOf(segment.front);
  Rgba back = colorOf(segment.back);
  front.a = front.a * Real(mostExtinction);
  back.a = back.a * Real(mostExtinction);
  return linearPiece(front, back, segment.length);
}
