// A face and the cells on both its sides, for gather.frag: three vertices a face, which fetch all they need by their
// number. Places are (x, y) across the view and the depth along it, relative to the mesh's centre.
#include "core/language.glsl"

uniform samplerBuffer points;        // position and scalar
uniform usamplerBuffer faceOrder;    // face by its place in the drawing order
uniform usamplerBuffer faceCorners;  // points a, b, c, counter-clockwise from the front, and that of the cell behind it
uniform usamplerBuffer backCorners;  // the point of the cell behind the back; kNone where there is none
#ifdef HAVS_CELL_DATA
uniform samplerBuffer faceScalars;  // of the cells behind the front and behind the back
flat out vec2 cellScalars;
#endif

uniform mat4 toClip;
uniform mat3 toView;  // right, up, forward

smooth out vec3 weights;  // of a, b, c
smooth out float scalar;
flat out vec3 cornerScalars;
// By how much the weight of each corner grows per unit of right, up and forward, in the cell behind the front and in
// that behind the back; and the scalar of that cell's fourth corner.
flat out vec4 frontA, frontB, frontC;
flat out vec4 backA, backB, backC;
flat out float hasBack;

const uint kNone = 0xFFFFFFFFu;

struct Gradients {
  vec4 a, b, c;
};

Gradients gradientsOf(vec3 a, vec3 b, vec3 c, vec4 behind) {
  vec3 u = a - behind.xyz, v = b - behind.xyz, w = c - behind.xyz;
  vec3 atA = cross(v, w);
  float volume = dot(u, atA);
  float scale = volume != 0.0 ? 1.0 / volume : 0.0;
  return Gradients(vec4(atA * scale, behind.w), vec4(cross(w, u) * scale, behind.w),
                   vec4(cross(u, v) * scale, behind.w));
}

void main() {
  int face = int(texelFetch(faceOrder, gl_VertexID / 3).r);
  uvec4 corners = texelFetch(faceCorners, face);
  uint back = texelFetch(backCorners, face).r;
  int which = gl_VertexID % 3;
  vec4 a = texelFetch(points, int(corners.x));
  vec4 b = texelFetch(points, int(corners.y));
  vec4 c = texelFetch(points, int(corners.z));
  vec4 own = which == 0 ? a : which == 1 ? b : c;
  gl_Position = toClip * vec4(own.xyz, 1.0);
  weights = vec3(which == 0, which == 1, which == 2);
  scalar = own.w;
  cornerScalars = vec3(a.w, b.w, c.w);
#ifdef HAVS_CELL_DATA
  cellScalars = texelFetch(faceScalars, face).rg;
#endif
  vec4 behindFront = texelFetch(points, int(corners.w));
  vec4 behindBack = texelFetch(points, int(back == kNone ? corners.w : back));
  hasBack = back == kNone ? 0.0 : 1.0;
  vec3 seenA = a.xyz * toView, seenB = b.xyz * toView, seenC = c.xyz * toView;
  Gradients gradients = gradientsOf(seenA, seenB, seenC, vec4(behindFront.xyz * toView, behindFront.w));
  frontA = gradients.a;
  frontB = gradients.b;
  frontC = gradients.c;
  gradients = gradientsOf(seenA, seenB, seenC, vec4(behindBack.xyz * toView, behindBack.w));
  backA = gradients.a;
  backB = gradients.b;
  backC = gradients.c;
}
