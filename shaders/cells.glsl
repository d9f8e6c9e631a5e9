// The stretch of the pixel's ray in the cell behind a face. The ray leaves through the face between the fourth corner d and
// that side of the entered triangle which lies beyond the pixel as seen from d. It must be the very face that the
// rasteriser draws there for the next cell, or the two stretches would overlap or leave a gap: so it is chosen among
// corners on the rasteriser's grid, and a pixel on an edge goes to the side that the fill rule says.
// Where a face is met is found from corners as they are: q is where a corner lies across the ray, in a plane sheared so that
// the ray is the line q = 0 and depth stays linear; twice the areas that the origin makes with the sides of the triangle
// of q weigh the corners' depth and scalar. A face is met at the same place, bit for bit, as the end of one cell and as
// the beginning of the next, also where it is seen edge-on and the place is any of its depths.
const float kMoveX = 1.0, kMoveY = 1.0;
flat in vec4 cornerA, cornerB, cornerC;
flat in vec4 behindFront, behindBack;
flat in vec2 snappedA, snappedB, snappedC, snappedBehindFront, snappedBehindBack;
flat in float hasBack;
#ifdef HAVS_CELL_DATA
flat in vec2 cellScalars;
#endif

// Per pixel, xy scale and zw offset from window coordinates: the ray's slope (0 for parallel rays), and where it passes
// through the plane of depth 0.
uniform vec4 pixelToRay;
uniform vec4 pixelToBase;
uniform float grid;

struct Corner {
  vec2 q;
  float depth;
  float scalar;
};

struct Place {
  float depth;
  float scalar;
};

struct CellStretch {
  Place entry;
  Place exit;
  float rayLength;  // along the ray for one unit of depth
};

Corner cornerAlong(vec4 corner, vec2 base, vec2 slope) {
  return Corner(corner.xy - (base + slope * corner.z), corner.z, corner.w);
}

Corner selectCorner(bool condition, Corner yes, Corner no) {
  return Corner(condition ? yes.q : no.q, condition ? yes.depth : no.depth, condition ? yes.scalar : no.scalar);
}

float turn(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

void bringInOrder(inout Corner a, inout Corner b) {
  bool swapped = b.depth != a.depth ? b.depth < a.depth : b.q.x != a.q.x ? b.q.x < a.q.x : b.q.y < a.q.y;
  Corner first = selectCorner(swapped, b, a);
  b = selectCorner(swapped, a, b);
  a = first;
}

// `x` kept to the range of three values and an eighth more: the pixel may lie beside the triangle by a step of the
// rasteriser's grid, but where that is much of its width, as seen edge-on, anything might come out.
float keptNear(float x, vec3 values) {
  float least = min(values.x, min(values.y, values.z)), most = max(values.x, max(values.y, values.z));
  float beyond = 0.125 * (most - least);
  return clamp(x, least - beyond, most + beyond);
}

// The corners come in any order: sums are taken in one of their own.
Place meet(Corner a, Corner b, Corner c) {
  bringInOrder(a, b);
  bringInOrder(b, c);
  bringInOrder(a, b);
  vec3 weights = vec3(turn(b.q, c.q), turn(c.q, a.q), turn(a.q, b.q));
  float sum = weights.x + weights.y + weights.z;
  weights = sum != 0.0 ? weights / sum : vec3(1.0 / 3.0);
  vec3 depths = vec3(a.depth, b.depth, c.depth), scalars = vec3(a.scalar, b.scalar, c.scalar);
  return Place(keptNear(dot(weights, depths), depths), clamp(keptNear(dot(weights, scalars), scalars), 0.0, 1.0));
}

// Whether the pixel lies to the left of the line from a to b, both relative to it; on the line it is moved a little, first
// along x, then along y.
bool isLeft(vec2 a, vec2 b) {
  float area = turn(a, b);
  float rise = a.y - b.y, run = b.x - a.x;
  return area != 0.0 ? area > 0.0 : rise != 0.0 ? kMoveX * rise > 0.0 : kMoveY * run > 0.0;
}

CellStretch stretchInCell() {
  vec2 pixel = gl_FragCoord.xy * grid;
  vec2 a = snappedA - pixel, b = snappedB - pixel, c = snappedC - pixel;
  vec2 d = (gl_FrontFacing ? snappedBehindFront : snappedBehindBack) - pixel;
  bool leftOfA = isLeft(d, a) == gl_FrontFacing;
  bool leftOfB = isLeft(d, b) == gl_FrontFacing;
  bool leftOfC = isLeft(d, c) == gl_FrontFacing;
  bool throughAB = leftOfA && !leftOfB;
  bool throughBC = leftOfB && !leftOfC;

  vec2 slope = gl_FragCoord.xy * pixelToRay.xy + pixelToRay.zw;
  vec2 base = gl_FragCoord.xy * pixelToBase.xy + pixelToBase.zw;
  Corner atA = cornerAlong(cornerA, base, slope);
  Corner atB = cornerAlong(cornerB, base, slope);
  Corner atC = cornerAlong(cornerC, base, slope);
  Corner atD = cornerAlong(gl_FrontFacing ? behindFront : behindBack, base, slope);
  CellStretch stretch;
  stretch.rayLength = sqrt(1.0 + dot(slope, slope));
  stretch.entry = meet(atA, atB, atC);
  stretch.exit = meet(selectCorner(throughAB, atA, selectCorner(throughBC, atB, atC)),
                      selectCorner(throughAB, atB, selectCorner(throughBC, atC, atA)), atD);
  return stretch;
}

bool entersCell() { return gl_FrontFacing || hasBack > 0.5; }
