#pragma once
#include <glad/gl.h>

#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "gl/handle.h"

namespace havs {

/// A buffer of fixed size. Its contents can be uploaded, in whole or in part, any number of times.
class Buffer {
 public:
  /// `bytes` of undefined contents (at least 1 is taken, OpenGL knows no empty buffers). Throws Error{running} when
  /// there is no memory.
  Buffer(const std::string& label, std::size_t bytes);

  /// A buffer that holds `data`.
  template <class T>
  static Buffer of(const std::string& label, std::span<const T> data) {
    Buffer buffer(label, data.size_bytes());
    buffer.upload(data);
    return buffer;
  }
  template <class T>
  static Buffer of(const std::string& label, const std::vector<T>& data) {
    return of(label, std::span<const T>(data));
  }

  /// Writes `data` from byte `offset` on. Throws Error{running} past the end.
  template <class T>
  void upload(std::span<const T> data, std::size_t offset = 0) {
    static_assert(std::is_trivially_copyable_v<T>);
    uploadBytes(std::as_bytes(data), offset);
  }
  /// `count` values of type T from byte `offset` on. Throws Error{running} past the end.
  template <class T>
  std::vector<T> read(std::size_t count, std::size_t offset = 0) const {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<T> data(count);
    readBytes(std::as_writable_bytes(std::span<T>(data)), offset);
    return data;
  }
  /// Hands all of it to `write` as values of type T, to be written in place of the old contents, without a copy in
  /// between.
  template <class T, class Write>
  void fill(const Write& write) {
    static_assert(std::is_trivially_copyable_v<T>);
    write(std::span<T>(static_cast<T*>(mapForWriting()), bytes_ / sizeof(T)));
    unmap();
  }
  /// Sets every byte to zero.
  void clear();
  /// Binds to an indexed target: GL_SHADER_STORAGE_BUFFER, GL_UNIFORM_BUFFER.
  void bindBase(GLenum target, GLuint index) const { glBindBufferBase(target, index, id()); }

  GLuint id() const { return handle_.id(); }
  std::size_t bytes() const { return bytes_; }

 private:
  void uploadBytes(std::span<const std::byte> data, std::size_t offset);
  void readBytes(std::span<std::byte> data, std::size_t offset) const;
  void* mapForWriting();
  void unmap();
  static void destroy(GLuint id) { glDeleteBuffers(1, &id); }

  Handle<destroy> handle_;
  std::size_t bytes_ = 0;
};

}  // namespace havs
