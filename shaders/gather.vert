// A face and the cell that rays enter through it, for gather.frag: three vertices a face, which fetch all they need by
// their number. Places are (x, y) across the view and the depth along it, relative to the mesh's centre.
#include "core/language.glsl"

uniform samplerBuffer points;        // position and scalar
uniform usamplerBuffer faceOrder;    // face by its place in the drawing order
uniform usamplerBuffer faceCorners;  // points a, b, c, counter-clockwise from the front, and that of the cell behind it
uniform usamplerBuffer backCorners;  // the point of the cell behind the back; kNone where there is none
#ifdef HAVS_CELL_DATA
uniform samplerBuffer faceScalars;  // of the cells behind the front and behind the back
flat out float cellScalar;
#endif

uniform mat4 toClip;
uniform mat3 toView;  // right, up, forward
uniform vec4 eye;     // for parallel rays the direction to it, and 0

smooth out vec2 weights;  // of a, b; that of c is what they leave of 1
smooth out float scalar;
// Of the cell behind the face: by how much the weight of each corner and the scalar grow per unit of right, up and
// forward, and the scalar's least and greatest value.
flat out vec3 gradientA, gradientB, gradientC, scalarGradient;
flat out vec2 scalarRange;

const uint kNone = 0xFFFFFFFFu;

void main() {
  int face = int(texelFetch(faceOrder, gl_VertexID / 3).r);
  uvec4 corners = texelFetch(faceCorners, face);
  uint back = texelFetch(backCorners, face).r;
  int which = gl_VertexID % 3;
  vec4 a = texelFetch(points, int(corners.x));
  vec4 b = texelFetch(points, int(corners.y));
  vec4 c = texelFetch(points, int(corners.z));
  // The side is taken here, where every pixel of the face gets the same: its fragments carry one cell, not two.
  bool fromFront = dot(cross(b.xyz - a.xyz, c.xyz - a.xyz), eye.xyz - eye.w * a.xyz) > 0.0;
  bool hasCell = fromFront || back != kNone;
  vec4 behind = texelFetch(points, int(hasCell && !fromFront ? back : corners.w));
  vec4 own = which == 0 ? a : which == 1 ? b : c;
  gl_Position = hasCell ? toClip * vec4(own.xyz, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);  // outside: nothing is drawn
  weights = vec2(which == 0, which == 1);
  scalar = own.w;
  scalarRange = vec2(min(min(a.w, b.w), min(c.w, behind.w)), max(max(a.w, b.w), max(c.w, behind.w)));
#ifdef HAVS_CELL_DATA
  vec2 ofCells = texelFetch(faceScalars, face).rg;
  cellScalar = fromFront ? ofCells.x : ofCells.y;
#endif
  vec3 u = (a.xyz - behind.xyz) * toView, v = (b.xyz - behind.xyz) * toView, w = (c.xyz - behind.xyz) * toView;
  vec3 atA = cross(v, w);
  float volume = dot(u, atA);
  float scale = volume != 0.0 ? 1.0 / volume : 0.0;
  gradientA = atA * scale;
  gradientB = cross(w, u) * scale;
  gradientC = cross(u, v) * scale;
  scalarGradient = gradientA * (a.w - behind.w) + gradientB * (b.w - behind.w) + gradientC * (c.w - behind.w);
}
