#include "gl/texture.h"

#include <fmt/format.h>

#include "core/error.h"
#include "gl/check.h"
#include "gl/limits.h"

namespace havs {

namespace {

GLuint createTexture(GLenum target) {
  GLuint id = 0;
  glCreateTextures(target, 1, &id);
  return id;
}

void requireSize(const std::string& label, int size, int limit) {
  if (size >= 1 && size <= limit) return;
  failRunning(fmt::format("texture '{}' of {} texels along an edge, this context takes 1 to {}", label, size, limit));
}

std::size_t bytesOf(GLenum type) { return type == GL_UNSIGNED_BYTE ? 1 : 4; }

GLint bytesPerTexel(GLuint buffer_texture) {
  GLint bits = 0, sum = 0;
  for (GLenum channel : {GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_ALPHA_SIZE}) {
    glGetTextureLevelParameteriv(buffer_texture, 0, channel, &bits);
    sum += bits;
  }
  return sum / 8;
}

}  // namespace

int componentsOf(GLenum format) {
  switch (format) {
    case GL_RED:
    case GL_RED_INTEGER:
      return 1;
    case GL_RG:
    case GL_RG_INTEGER:
      return 2;
    case GL_RGB:
    case GL_RGB_INTEGER:
      return 3;
    case GL_RGBA:
    case GL_RGBA_INTEGER:
      return 4;
    default:
      failRunning(fmt::format("pixel format {:#x} is not known here", format));
  }
}

Texture::Texture(GLenum target, const std::string& label, int width, int height, int depth)
    : handle_(createTexture(target)), target_(target), label_(label), width_(width), height_(height), depth_(depth) {
  setLabel(GL_TEXTURE, id(), label);
  if (target == GL_TEXTURE_BUFFER) return;
  for (GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
    glTextureParameteri(id(), wrap, GL_CLAMP_TO_EDGE);
  }
  filter(GL_NEAREST);
}

Texture Texture::image1D(const std::string& label, GLenum format, int width) {
  requireSize(label, width, limits().textureSize);
  Texture texture(GL_TEXTURE_1D, label, width, 1, 1);
  glTextureStorage1D(texture.id(), 1, format, width);
  checkGl(fmt::format("allocating texture '{}' of {} texels", label, width));
  return texture;
}

Texture Texture::image2D(const std::string& label, GLenum format, int width, int height) {
  requireSize(label, width, limits().textureSize);
  requireSize(label, height, limits().textureSize);
  Texture texture(GL_TEXTURE_2D, label, width, height, 1);
  glTextureStorage2D(texture.id(), 1, format, width, height);
  checkGl(fmt::format("allocating texture '{}' of {} x {} texels", label, width, height));
  return texture;
}

Texture Texture::image3D(const std::string& label, GLenum format, int width, int height, int depth) {
  for (int size : {width, height, depth}) requireSize(label, size, limits().texture3dSize);
  Texture texture(GL_TEXTURE_3D, label, width, height, depth);
  glTextureStorage3D(texture.id(), 1, format, width, height, depth);
  checkGl(fmt::format("allocating texture '{}' of {} x {} x {} texels", label, width, height, depth));
  return texture;
}

Texture Texture::overBuffer(const std::string& label, GLenum format, const Buffer& buffer) {
  Texture texture(GL_TEXTURE_BUFFER, label, 0, 1, 1);
  glTextureBuffer(texture.id(), format, buffer.id());
  checkGl(fmt::format("making buffer texture '{}'", label));
  const std::size_t texels = buffer.bytes() / static_cast<std::size_t>(bytesPerTexel(texture.id()));
  const auto limit = static_cast<std::size_t>(limits().bufferTexels);
  if (texels > limit) {
    failRunning(fmt::format("buffer texture '{}' of {} texels, this context takes {}", label, texels, limit));
  }
  texture.width_ = static_cast<int>(texels);
  return texture;
}

void Texture::filter(GLint filter) {
  glTextureParameteri(id(), GL_TEXTURE_MIN_FILTER, filter);
  glTextureParameteri(id(), GL_TEXTURE_MAG_FILTER, filter);
}

void Texture::uploadAs(GLenum format, GLenum type, std::span<const std::byte> values) {
  const std::size_t texels =
      static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * static_cast<std::size_t>(depth_);
  const std::size_t needed = texels * static_cast<std::size_t>(componentsOf(format)) * bytesOf(type);
  if (values.size() != needed) {
    failRunning(fmt::format("{} bytes for texture '{}', which takes {}", values.size(), label_, needed));
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  switch (target_) {
    case GL_TEXTURE_1D:
      glTextureSubImage1D(id(), 0, 0, width_, format, type, values.data());
      break;
    case GL_TEXTURE_2D:
      glTextureSubImage2D(id(), 0, 0, 0, width_, height_, format, type, values.data());
      break;
    case GL_TEXTURE_3D:
      glTextureSubImage3D(id(), 0, 0, 0, 0, width_, height_, depth_, format, type, values.data());
      break;
    default:
      failRunning("texture '" + label_ + "' takes its texels from a buffer");
  }
  checkGl("uploading texture '" + label_ + "'");
}

}  // namespace havs
