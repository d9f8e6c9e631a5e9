#include "gl/framebuffer.h"

#include <fmt/format.h>

#include "core/error.h"
#include "gl/check.h"
#include "gl/limits.h"

namespace havs {

namespace {

GLuint createFramebuffer() {
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  return id;
}

std::string statusText(GLenum status) {
  switch (status) {
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
      return "a target has a format that cannot be drawn to";
    case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
      return "it has no target";
    case GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER:
      return "a draw buffer has no target";
    case GL_FRAMEBUFFER_UNSUPPORTED:
      return "the driver cannot draw to this combination of formats";
    case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE:
      return "its targets have different numbers of samples";
    case GL_FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS:
      return "only some of its targets have layers";
    default:
      return fmt::format("status {:#x}", status);
  }
}

}  // namespace

Framebuffer::Framebuffer(const std::string& label, const Targets& colours, const Texture* stencil)
    : handle_(createFramebuffer()), label_(label) {
  setLabel(GL_FRAMEBUFFER, id(), label);
  const auto limit = static_cast<std::size_t>(limits().drawBuffers);
  if (colours.empty() || colours.size() > limit) {
    failRunning(fmt::format("framebuffer '{}' of {} targets, this context takes 1 to {}", label, colours.size(), limit),
                "", "try a smaller --k");
  }
  width_ = colours.front().get().width();
  height_ = colours.front().get().height();
  std::vector<GLenum> drawBuffers;
  for (const Texture& colour : colours) {
    if (colour.width() != width_ || colour.height() != height_) {
      failRunning(fmt::format("framebuffer '{}': target '{}' is {} x {} pixels, the first is {} x {}", label,
                              colour.label(), colour.width(), colour.height(), width_, height_));
    }
    const GLenum attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(drawBuffers.size());
    glNamedFramebufferTexture(id(), attachment, colour.id(), 0);
    drawBuffers.push_back(attachment);
  }
  if (stencil != nullptr) glNamedFramebufferTexture(id(), GL_STENCIL_ATTACHMENT, stencil->id(), 0);
  glNamedFramebufferDrawBuffers(id(), static_cast<GLsizei>(drawBuffers.size()), drawBuffers.data());
  const GLenum status = glCheckNamedFramebufferStatus(id(), GL_DRAW_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    failRunning(fmt::format("framebuffer '{}' cannot be used: {}", label, statusText(status)));
  }
  checkGl("making framebuffer '" + label + "'");
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, id());
  glViewport(0, 0, width_, height_);
}

void Framebuffer::clear(int i, const std::array<float, 4>& value) const {
  glClearNamedFramebufferfv(id(), GL_COLOR, i, value.data());
}

void Framebuffer::clear(int i, const std::array<std::uint32_t, 4>& value) const {
  glClearNamedFramebufferuiv(id(), GL_COLOR, i, value.data());
}

std::vector<float> Framebuffer::readFloats(int i, GLenum format) const {
  std::vector<float> pixels(valuesOf(format));
  read(i, format, GL_FLOAT, pixels.data(), width_, height_);
  return pixels;
}

std::vector<std::uint32_t> Framebuffer::readUints(int i, GLenum format) const {
  std::vector<std::uint32_t> pixels(valuesOf(format));
  read(i, format, GL_UNSIGNED_INT, pixels.data(), width_, height_);
  return pixels;
}

std::size_t Framebuffer::valuesOf(GLenum format) const {
  return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) *
         static_cast<std::size_t>(componentsOf(format));
}

void Framebuffer::readInto(float* pixels, int i, int width, int height, int rowPixels) const {
  glPixelStorei(GL_PACK_ROW_LENGTH, rowPixels);
  read(i, GL_RGBA, GL_FLOAT, pixels, width, height);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
}

void Framebuffer::read(int i, GLenum format, GLenum type, void* pixels, int width, int height) const {
  glNamedFramebufferReadBuffer(id(), GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, id());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, format, type, pixels);
  checkGl(fmt::format("reading target {} of framebuffer '{}'", i, label_));
}

}  // namespace havs
