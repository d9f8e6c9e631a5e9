#pragma once
#include <glad/gl.h>

#include <cstddef>
#include <string>

#include "gl/buffer.h"
#include "gl/handle.h"

namespace havs {

/// Where the attributes of a vertex come from. The buffers must outlive it.
class VertexArray {
 public:
  explicit VertexArray(const std::string& label);

  /// Attribute `location` is `components` values of `type` (GL_FLOAT, ...), the first at byte `offset`, the next vertex
  /// `stride` bytes on; integers are converted to float, to [0,1] or [-1,1] where `normalised`.
  void attribute(GLuint location, const Buffer& buffer, GLint components, GLenum type, GLsizei stride,
                 std::size_t offset = 0, bool normalised = false);
  /// The same for an integer attribute (int, uint, uvec2, ... in the shader).
  void integerAttribute(GLuint location, const Buffer& buffer, GLint components, GLenum type, GLsizei stride,
                        std::size_t offset = 0);
  /// The indices of glDrawElements.
  void elements(const Buffer& indices) { glVertexArrayElementBuffer(id(), indices.id()); }
  void bind() const { glBindVertexArray(id()); }

  GLuint id() const { return handle_.id(); }

 private:
  static void destroy(GLuint id) { glDeleteVertexArrays(1, &id); }

  Handle<destroy> handle_;
};

}  // namespace havs
