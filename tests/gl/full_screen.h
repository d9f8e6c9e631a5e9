#pragma once
// Triangles that cover every pixel, many in one draw call, without vertex data.
#include <glad/gl.h>

namespace havs {

/// Triangle i of a draw call covers everything; the fragment shader gets i as `flat in int triangle`.
inline constexpr const char* kFullScreenVertex = R"(
flat out int triangle;
void main() {
  triangle = gl_VertexID / 3;
  int corner = gl_VertexID % 3;
  gl_Position = vec4(corner == 1 ? 3.0 : -1.0, corner == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";

inline void drawFullScreen(int triangles) {
  GLuint array = 0;
  glCreateVertexArrays(1, &array);
  glBindVertexArray(array);
  glDrawArrays(GL_TRIANGLES, 0, 3 * triangles);
  glDeleteVertexArrays(1, &array);
}

}  // namespace havs
