// A face and the cells on both its sides, for cells.frag: three vertices a face, which fetch all they need by their number.
// Corners are (x, y) across the view, depth along it, relative to the mesh's centre, and the scalar.
uniform samplerBuffer points;         // position and scalar
uniform usamplerBuffer faceOrder;     // face by its place in the drawing order
uniform usamplerBuffer faceCorners;   // points a, b, c, counter-clockwise from the front, and that of the cell behind the front
uniform usamplerBuffer backCorners;   // the point of the cell behind the back; kNone where there is none
#ifdef HAVS_CELL_DATA
uniform samplerBuffer faceScalars;  // of the cells behind the front and behind the back
flat out vec2 cellScalars;
#endif

uniform mat4 toClip;
uniform mat3 toView;  // right, up, forward
uniform vec2 viewport;  // pixels
uniform float grid;     // steps of a pixel that the rasteriser snaps corners to

// Where the rasteriser puts them, in steps of its grid.
flat out vec2 snappedA, snappedB, snappedC, snappedBehindFront, snappedBehindBack;
flat out vec4 cornerA, cornerB, cornerC;      // of the face
flat out vec4 behindFront, behindBack;        // the fourth corners of the two cells
flat out float hasBack;                       // 0: rays leave the mesh through the back

const uint kNone = 0xFFFFFFFFu;

invariant gl_Position;  // passes that look at the same faces must cover the same pixels

vec4 corner(uint point) {
  vec4 p = texelFetch(points, int(point));
  return vec4(p.xyz * toView, p.w);
}

vec4 clipPlace(uint point) { return toClip * vec4(texelFetch(points, int(point)).xyz, 1.0); }

vec2 snapped(uint point) {
  vec4 clip = clipPlace(point);
  vec2 window = clip.xy * (1.0 / clip.w) * (0.5 * viewport) + 0.5 * viewport;
  return roundEven(window * grid);
}

void main() {
  int face = int(texelFetch(faceOrder, gl_VertexID / 3).r);
  uvec4 corners = texelFetch(faceCorners, face);
  uint back = texelFetch(backCorners, face).r;
  cornerA = corner(corners.x);
  cornerB = corner(corners.y);
  cornerC = corner(corners.z);
  behindFront = corner(corners.w);
  hasBack = back == kNone ? 0.0 : 1.0;
  behindBack = corner(back == kNone ? corners.w : back);
#ifdef HAVS_CELL_DATA
  cellScalars = texelFetch(faceScalars, face).rg;
#endif
  int which = gl_VertexID % 3;
  uint own = which == 0 ? corners.x : which == 1 ? corners.y : corners.z;
  gl_Position = clipPlace(own);
  snappedA = snapped(corners.x);
  snappedB = snapped(corners.y);
  snappedC = snapped(corners.z);
  snappedBehindFront = snapped(corners.w);
  snappedBehindBack = snapped(back == kNone ? corners.w : back);
}
