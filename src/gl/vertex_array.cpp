#include "gl/vertex_array.h"

namespace havs {

namespace {

GLuint createVertexArray() {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  return id;
}

// Binding point and attribute have the same number, so that each attribute has a buffer of its own.
void bindBuffer(GLuint array, GLuint location, const Buffer& buffer, GLsizei stride, std::size_t offset) {
  glEnableVertexArrayAttrib(array, location);
  glVertexArrayVertexBuffer(array, location, buffer.id(), static_cast<GLintptr>(offset), stride);
  glVertexArrayAttribBinding(array, location, location);
}

}  // namespace

VertexArray::VertexArray(const std::string& label) : handle_(createVertexArray()) {
  setLabel(GL_VERTEX_ARRAY, id(), label);
}

void VertexArray::attribute(GLuint location, const Buffer& buffer, GLint components, GLenum type, GLsizei stride,
                            std::size_t offset, bool normalised) {
  bindBuffer(id(), location, buffer, stride, offset);
  glVertexArrayAttribFormat(id(), location, components, type, normalised ? GL_TRUE : GL_FALSE, 0);
}

void VertexArray::integerAttribute(GLuint location, const Buffer& buffer, GLint components, GLenum type, GLsizei stride,
                                   std::size_t offset) {
  bindBuffer(id(), location, buffer, stride, offset);
  glVertexArrayAttribIFormat(id(), location, components, type, 0);
}

}  // namespace havs
