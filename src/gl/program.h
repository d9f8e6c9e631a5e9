#pragma once
#include <glad/gl.h>

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "gl/handle.h"
#include "gl/shader_source.h"

namespace havs {

/// A linked program.
class Program {
 public:
  struct Stage {
    GLenum type;  ///< GL_VERTEX_SHADER, GL_FRAGMENT_SHADER, GL_COMPUTE_SHADER
    ShaderSource source;
  };
  /// Throws Error{running} where a stage does not compile (with file, line and its text) or the stages do not link.
  Program(const std::string& label, const std::vector<Stage>& stages);

  void use() const { glUseProgram(id()); }

  /// Sets a uniform. One that the program does not use is passed over: the compiler drops what a variant has no need
  /// for.
  void set(const char* name, int value) const { glProgramUniform1i(id(), location(name), value); }
  void set(const char* name, unsigned value) const { glProgramUniform1ui(id(), location(name), value); }
  void set(const char* name, float value) const { glProgramUniform1f(id(), location(name), value); }
  void set(const char* name, const glm::vec2& v) const { glProgramUniform2f(id(), location(name), v.x, v.y); }
  void set(const char* name, const glm::vec3& v) const { glProgramUniform3f(id(), location(name), v.x, v.y, v.z); }
  void set(const char* name, const glm::vec4& v) const { glProgramUniform4f(id(), location(name), v.x, v.y, v.z, v.w); }
  void set(const char* name, const glm::ivec2& v) const { glProgramUniform2i(id(), location(name), v.x, v.y); }
  void set(const char* name, const glm::mat3& m) const {
    glProgramUniformMatrix3fv(id(), location(name), 1, GL_FALSE, &m[0][0]);
  }
  void set(const char* name, const glm::mat4& m) const {
    glProgramUniformMatrix4fv(id(), location(name), 1, GL_FALSE, &m[0][0]);
  }
  void set(const char* name, std::span<const float> values) const {
    glProgramUniform1fv(id(), location(name), static_cast<GLsizei>(values.size()), values.data());
  }
  bool uses(const char* uniform) const { return location(uniform) >= 0; }

  GLuint id() const { return handle_.id(); }

 private:
  GLint location(const char* name) const { return glGetUniformLocation(id(), name); }
  static void destroy(GLuint id) { glDeleteProgram(id); }

  Handle<destroy> handle_;
};

}  // namespace havs
