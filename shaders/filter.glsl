#pragma once
// Tables over [0, 1] along each axis, linear between entries: the first entry at 0, the last at 1. (The native device
// has its own: src/render/native/shaders/filter.glsl.)
#define Table2d sampler2D
#define Table3d sampler3D
uniform vec3 tableScale;  // half-texel correction
uniform vec3 tableBias;

#ifdef HAVS_FILTER_IN_SHADER
// llvmpipe filters 8-bit textures with 8 bits; the entries are mixed here in float.
vec4 fetchTable(sampler3D table, float x, float y, float z) {
  vec3 unit = vec3(x, y, z);
  vec3 last = vec3(textureSize(table, 0) - 1);
  vec3 place = unit * last;
  vec3 low = min(floor(place), last - 1.0);
  vec3 t = place - low;
  ivec3 i = ivec3(low);
#define ENTRY(x, y, z) texelFetch(table, i + ivec3(x, y, z), 0)
  vec4 near = mix(mix(ENTRY(0, 0, 0), ENTRY(1, 0, 0), t.x), mix(ENTRY(0, 1, 0), ENTRY(1, 1, 0), t.x), t.y);
  vec4 far = mix(mix(ENTRY(0, 0, 1), ENTRY(1, 0, 1), t.x), mix(ENTRY(0, 1, 1), ENTRY(1, 1, 1), t.x), t.y);
#undef ENTRY
  return mix(near, far, t.z);
}

vec4 fetchTable(sampler2D table, float x, float y) {
  vec2 unit = vec2(x, y);
  vec2 last = vec2(textureSize(table, 0) - 1);
  vec2 place = unit * last;
  vec2 low = min(floor(place), last - 1.0);
  vec2 t = place - low;
  ivec2 i = ivec2(low);
#define ENTRY(x, y) texelFetch(table, i + ivec2(x, y), 0)
  return mix(mix(ENTRY(0, 0), ENTRY(1, 0), t.x), mix(ENTRY(0, 1), ENTRY(1, 1), t.x), t.y);
#undef ENTRY
}
#else
vec4 fetchTable(sampler3D table, float x, float y, float z) {
  return textureLod(table, vec3(x, y, z) * tableScale + tableBias, 0.0);
}
vec4 fetchTable(sampler2D table, float x, float y) {
  return textureLod(table, vec2(x, y) * tableScale.xy + tableBias.xy, 0.0);
}
#endif
