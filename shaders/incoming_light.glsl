// The light that falls on a face's fragment: interpolated numbers of the mesh's points (LightPlan) under the scene's
// lights.
#include "core/lighting.glsl"

smooth in vec4 lightRow[HAVS_LIGHT_VECTORS];
smooth in vec3 place;

uniform vec3 forward, viewRight, viewUp;
uniform float modulation;

float lightNumber(int i) { return lightRow[i / 4][i % 4]; }

Direction directionOf(vec3 v) {
  Direction d;
  d.x = v.x;
  d.y = v.y;
  d.z = v.z;
  return d;
}

#ifdef HAVS_GRADIENT_AT
vec3 gradientThere() {
  return vec3(lightNumber(HAVS_GRADIENT_AT), lightNumber(HAVS_GRADIENT_AT + 1), lightNumber(HAVS_GRADIENT_AT + 2));
}
#endif

#ifdef HAVS_PHONG
uniform vec4 lightPlaces[HAVS_LIGHTS];    // w 1: where the light is; 0: the direction towards it
uniform float lightIntensities[HAVS_LIGHTS];
uniform vec4 lightCoefficients;           // ambient, diffuse, specular, silhouettes
uniform int shininess;

vec3 towardsLight(int i) {
  if (lightPlaces[i].w < 0.5) return lightPlaces[i].xyz;
  vec3 way = lightPlaces[i].xyz - place;
  float squared = dot(way, way);
  return squared > 0.0 ? way * (1.0 / sqrt(squared)) : vec3(0.0);
}
#endif

// slope: of the pixel's ray, as pixelToRay has it.
float incomingLight(vec2 slope) {
  float light = 1.0;
#ifdef HAVS_PHONG
  vec3 ray = forward + slope.x * viewRight + slope.y * viewUp;
  LitPoint point = litPoint(directionOf(gradientThere()), directionOf(ray * (-1.0 / length(ray))));
  light = lightCoefficients.x;
#ifdef HAVS_OCCLUSION_AT
  light *= lightNumber(HAVS_OCCLUSION_AT);
#endif
  for (int i = 0; i < HAVS_LIGHTS; ++i) {
    float from = lightFrom(point, directionOf(towardsLight(i)), lightCoefficients.y, lightCoefficients.z, shininess);
#ifdef HAVS_SHADOWS_AT
    from *= lightNumber(HAVS_SHADOWS_AT + i);
#endif
    light += lightIntensities[i] * from;
  }
#ifdef HAVS_SILHOUETTES
  light *= silhouetteAt(point, lightCoefficients.w);
#endif
#endif
#ifdef HAVS_SCATTERED_AT
  light += lightNumber(HAVS_SCATTERED_AT);
#endif
  return light;
}

float incomingDensity() {
#ifdef HAVS_MODULATION
  return (1.0 - modulation) + modulation * min(length(gradientThere()), 1.0);
#else
  return 1.0;
#endif
}
