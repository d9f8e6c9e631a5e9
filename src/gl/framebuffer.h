#pragma once
#include <glad/gl.h>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "gl/handle.h"
#include "gl/texture.h"

namespace havs {

/// Colour targets that are drawn to together: attachment i is `layout(location = i)` of the fragment shader.
class Framebuffer {
 public:
  using Targets = std::vector<std::reference_wrapper<const Texture>>;

  /// `colours`: 2D textures, all of one size, which must outlive it; their formats may differ. `stencil`: one more of
  /// that size (GL_STENCIL_INDEX8). Throws Error{running}
  /// where they are more than the context can draw to, or where it cannot draw to this combination (the message says
  /// why).
  Framebuffer(const std::string& label, const Targets& colours, const Texture* stencil = nullptr);

  /// Drawing goes here from now on; the viewport is all of it.
  void bind() const;
  /// Sets every pixel of attachment `i`. Bits of floats are kept as they are. Colour masks and scissors hold.
  void clear(int i, const std::array<float, 4>& value) const;
  void clear(int i, const std::array<std::uint32_t, 4>& value) const;
  /// Pixels of attachment `i` as `format` (GL_RGBA, GL_RED, ...), rows from the bottom up as OpenGL has them.
  std::vector<float> readFloats(int i, GLenum format = GL_RGBA) const;
  /// The lower left `width` x `height` pixels of attachment `i` as RGBA into rows that begin `rowPixels` pixels apart.
  void readInto(float* pixels, int i, int width, int height, int rowPixels) const;
  std::vector<std::uint32_t> readUints(int i, GLenum format = GL_RGBA_INTEGER) const;

  GLuint id() const { return handle_.id(); }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  void read(int i, GLenum format, GLenum type, void* pixels, int width, int height) const;
  std::size_t valuesOf(GLenum format) const;
  static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }

  Handle<destroy> handle_;
  std::string label_;
  int width_ = 0, height_ = 0;
};

}  // namespace havs
