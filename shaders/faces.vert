// The corners of the mesh's faces, in the local frame. Points of boundary faces come a second time, after all points:
// the number of the vertex tells whether its face has a cell on one side only.
layout(location = 0) in vec4 pointAndScalar;
#ifdef HAVS_COLOR_PAYLOAD
layout(location = 1) in vec4 vertexColor;  // (r, g, b, extinction as a fraction of the largest)
smooth out vec4 colorAndExtinction;
#endif

#ifdef HAVS_LIT
layout(location = 2) in vec4 vertexLight[HAVS_LIGHT_VECTORS];
smooth out vec4 lightRow[HAVS_LIGHT_VECTORS];
smooth out vec3 place;
#endif

uniform mat4 toClip;
uniform vec3 forward;
uniform int firstBoundaryVertex;

smooth out float scalar;
flat out float cornerScalar;  // of one corner
smooth out float depth;  // along the view, relative to the mesh's centre: no cancellation for a distant eye
flat out float onBoundary;

invariant gl_Position;  // passes that count faces and draw them must cover the same pixels

void main() {
  scalar = pointAndScalar.w;
  cornerScalar = pointAndScalar.w;
  depth = dot(forward, pointAndScalar.xyz);
#ifdef HAVS_COLOR_PAYLOAD
  colorAndExtinction = vertexColor;
#endif
#ifdef HAVS_LIT
  lightRow = vertexLight;
  place = pointAndScalar.xyz;
#endif
  onBoundary = gl_VertexID >= firstBoundaryVertex ? 1.0 : 0.0;
  gl_Position = toClip * vec4(pointAndScalar.xyz, 1.0);
}
