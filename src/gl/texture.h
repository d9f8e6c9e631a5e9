#pragma once
#include <glad/gl.h>

#include <span>
#include <string>

#include "gl/buffer.h"
#include "gl/handle.h"

namespace havs {

/// A texture of fixed size and format, one level. Clamped to its edge, filtered by nearest until told otherwise.
class Texture {
 public:
  /// `format`: a sized internal format (GL_RGBA32F, ...). Sizes in texels, at least 1. Throws Error{running} beyond the
  /// context's limits or when there is no memory.
  static Texture image1D(const std::string& label, GLenum format, int width);
  static Texture image2D(const std::string& label, GLenum format, int width, int height);
  static Texture image3D(const std::string& label, GLenum format, int width, int height, int depth);
  /// The texels are those of `buffer`, which must outlive the texture (samplerBuffer, usamplerBuffer in the shader).
  /// Throws Error{running} where it holds more texels than the context can address.
  static Texture overBuffer(const std::string& label, GLenum format, const Buffer& buffer);

  /// Fills all of it with `values`: texels of `format` (GL_RGBA, GL_RED_INTEGER, ...) in T's type, x fastest.
  /// Throws Error{running} where their number is another than the texture's.
  void upload(GLenum format, std::span<const float> values) { uploadAs(format, GL_FLOAT, std::as_bytes(values)); }
  void upload(GLenum format, std::span<const std::uint32_t> values) {
    uploadAs(format, GL_UNSIGNED_INT, std::as_bytes(values));
  }
  void upload(GLenum format, std::span<const std::uint8_t> values) {
    uploadAs(format, GL_UNSIGNED_BYTE, std::as_bytes(values));
  }
  /// GL_NEAREST or GL_LINEAR. (llvmpipe's linear filter has 8 bits for 8-bit formats, full float for floating-point
  /// ones.)
  void filter(GLint filter);
  void bind(GLuint unit) const { glBindTextureUnit(unit, id()); }

  GLuint id() const { return handle_.id(); }
  int width() const { return width_; }
  int height() const { return height_; }
  int depth() const { return depth_; }
  const std::string& label() const { return label_; }

 private:
  Texture(GLenum target, const std::string& label, int width, int height, int depth);
  void uploadAs(GLenum format, GLenum type, std::span<const std::byte> values);
  static void destroy(GLuint id) { glDeleteTextures(1, &id); }

  Handle<destroy> handle_;
  GLenum target_;
  std::string label_;
  int width_, height_, depth_;
};

/// Values a texel of a client format has: 1 for GL_RED, 4 for GL_RGBA, ... Throws Error{running} for a format not used
/// here.
int componentsOf(GLenum format);

}  // namespace havs
