// The stretch of the pixel's ray in the cell behind a face. All corners are looked at along the ray: q is where a corner
// lies across it, in a plane that is sheared so that the ray is the line q = 0 and depth stays linear. A face is met where
// its triangle of q holds the origin; twice the areas that the origin makes with its sides weigh depth and scalar of its
// corners. These are differences of numbers near 1 only in q itself: as good as the rasteriser's own interpolation, and no
// plane is ever divided by. The ray leaves through the face between the fourth corner d and that side of the entered
// triangle which lies beyond the origin as seen from d.
flat in vec4 cornerA, cornerB, cornerC;
flat in vec4 behindFront, behindBack;
flat in float hasBack;
#ifdef HAVS_CELL_DATA
flat in vec2 cellScalars;
#endif

// Per pixel, xy scale and zw offset from window coordinates: the ray's slope (0 for parallel rays), and where it passes
// through the plane of depth 0.
uniform vec4 pixelToRay;
uniform vec4 pixelToBase;

struct Place {
  float depth;
  float scalar;
};

float turn(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// Weights below 0 are those of a ray that misses the face by less than the rasteriser's grid: it passes the side.
Place meet(vec3 weights, vec4 a, vec4 b, vec4 c) {
  vec3 w = max(weights, 0.0);
  float sum = w.x + w.y + w.z;
  w = sum > 0.0 ? w / sum : vec3(1.0 / 3.0);
  return Place(dot(w, vec3(a.z, b.z, c.z)), dot(w, vec3(a.w, b.w, c.w)));
}

struct CellStretch {
  Place entry;
  Place exit;
  float rayLength;  // along the ray for one unit of depth
};

CellStretch stretchInCell() {
  vec4 cornerD = gl_FrontFacing ? behindFront : behindBack;
  vec2 slope = gl_FragCoord.xy * pixelToRay.xy + pixelToRay.zw;
  vec2 base = gl_FragCoord.xy * pixelToBase.xy + pixelToBase.zw;
  vec2 a = cornerA.xy - (base + slope * cornerA.z);
  vec2 b = cornerB.xy - (base + slope * cornerB.z);
  vec2 c = cornerC.xy - (base + slope * cornerC.z);
  vec2 d = cornerD.xy - (base + slope * cornerD.z);
  vec3 face = vec3(turn(b, c), turn(c, a), turn(a, b));
  float side = face.x + face.y + face.z < 0.0 ? -1.0 : 1.0;
  face *= side;
  vec3 spokes = side * vec3(turn(d, a), turn(d, b), turn(d, c));

  CellStretch stretch;
  stretch.rayLength = sqrt(1.0 + dot(slope, slope));
  stretch.entry = meet(face, cornerA, cornerB, cornerC);
  bool throughAB = spokes.x >= 0.0 && spokes.y < 0.0;
  bool throughBC = !throughAB && spokes.y >= 0.0 && spokes.z < 0.0;
  // The side's two corners, then d, whose weight is the area beyond the side.
  vec4 first = throughAB ? cornerA : throughBC ? cornerB : cornerC;
  vec4 second = throughAB ? cornerB : throughBC ? cornerC : cornerA;
  vec3 weights = throughAB   ? vec3(-spokes.y, spokes.x, face.z)
                 : throughBC ? vec3(-spokes.z, spokes.y, face.x)
                             : vec3(-spokes.x, spokes.z, face.y);
  stretch.exit = meet(weights, first, second, cornerD);
  return stretch;
}

bool entersCell() { return gl_FrontFacing || hasBack > 0.5; }
