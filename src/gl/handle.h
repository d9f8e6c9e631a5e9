#pragma once
#include <glad/gl.h>

#include <string_view>
#include <utility>

namespace havs {

/// Owns the name of one OpenGL object: moved, never copied, deleted with its owner (while the device lives).
template <void (*destroy)(GLuint)>
class Handle {
 public:
  Handle() = default;
  explicit Handle(GLuint id) : id_(id) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Handle() {
    if (id_ != 0) destroy(id_);
  }
  GLuint id() const { return id_; }

 private:
  GLuint id_ = 0;
};

/// Names an object for debuggers and the driver's messages. `type`: GL_BUFFER, GL_TEXTURE, GL_PROGRAM, ...
inline void setLabel(GLenum type, GLuint id, std::string_view label) {
  constexpr std::size_t kLongest = 255;  // the least GL_MAX_LABEL_LENGTH, less the end
  const auto length = static_cast<GLsizei>(label.size() < kLongest ? label.size() : kLongest);
  glObjectLabel(type, id, length, label.data());
}

}  // namespace havs
