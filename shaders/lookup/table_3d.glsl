// The paper's lookup: the pre-integrated table over (front scalar, back scalar, length), with half-texel scale and
// bias.
uniform sampler3D preintegrated;
uniform vec2 tableScaleBias;
uniform float lengthScale;  // 1 / the length of the table's last entry

#ifdef HAVS_FILTER_IN_SHADER
// llvmpipe filters 8-bit textures with 8 bits; the eight entries are mixed here in float.
vec4 fetchTable(vec3 unit) {
  vec3 last = vec3(textureSize(preintegrated, 0) - 1);
  vec3 place = unit * last;
  vec3 low = min(floor(place), last - 1.0);
  vec3 t = place - low;
  ivec3 i = ivec3(low);
#define ENTRY(x, y, z) texelFetch(preintegrated, i + ivec3(x, y, z), 0)
  vec4 near = mix(mix(ENTRY(0, 0, 0), ENTRY(1, 0, 0), t.x), mix(ENTRY(0, 1, 0), ENTRY(1, 1, 0), t.x), t.y);
  vec4 far = mix(mix(ENTRY(0, 0, 1), ENTRY(1, 0, 1), t.x), mix(ENTRY(0, 1, 1), ENTRY(1, 1, 1), t.x), t.y);
#undef ENTRY
  return mix(near, far, t.z);
}
#else
vec4 fetchTable(vec3 unit) { return texture(preintegrated, unit * tableScaleBias.x + tableScaleBias.y); }
#endif

Rgba lookUp(Segment segment) {
  return fetchTable(vec3(segment.scalarFront, segment.scalarBack, min(segment.length * lengthScale, 1.0)));
}
