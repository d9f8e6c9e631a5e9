#include "gl/buffer.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "gl/check.h"

namespace havs {

namespace {

GLuint createBuffer() {
  GLuint id = 0;
  glCreateBuffers(1, &id);
  return id;
}

void requireWithin(std::size_t bytes, std::size_t offset, std::size_t size) {
  if (offset > size || bytes > size - offset) {
    failRunning(fmt::format("{} bytes at {} lie outside an OpenGL buffer of {} bytes", bytes, offset, size));
  }
}

}  // namespace

Buffer::Buffer(const std::string& label, std::size_t bytes) : handle_(createBuffer()), bytes_(bytes) {
  setLabel(GL_BUFFER, id(), label);
  glNamedBufferStorage(id(), static_cast<GLsizeiptr>(std::max<std::size_t>(bytes, 1)), nullptr,
                       GL_DYNAMIC_STORAGE_BIT | GL_MAP_WRITE_BIT);
  checkGl(fmt::format("allocating buffer '{}' of {} bytes", label, bytes));
}

void Buffer::uploadBytes(std::span<const std::byte> data, std::size_t offset) {
  requireWithin(data.size(), offset, bytes_);
  if (data.empty()) return;
  glNamedBufferSubData(id(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(data.size()), data.data());
}

void Buffer::readBytes(std::span<std::byte> data, std::size_t offset) const {
  requireWithin(data.size(), offset, bytes_);
  if (data.empty()) return;
  glGetNamedBufferSubData(id(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(data.size()), data.data());
}

void* Buffer::mapForWriting() {
  void* memory = glMapNamedBufferRange(id(), 0, static_cast<GLsizeiptr>(std::max<std::size_t>(bytes_, 1)),
                                       GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
  if (!memory) failRunning(fmt::format("an OpenGL buffer of {} bytes cannot be written to", bytes_));
  return memory;
}

void Buffer::unmap() { glUnmapNamedBuffer(id()); }

void Buffer::clear() { glClearNamedBufferData(id(), GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, nullptr); }

}  // namespace havs
