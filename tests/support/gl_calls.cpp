#include "support/gl_calls.h"

#include <glad/gl.h>

#include <functional>
#include <stdexcept>
#include <utility>

namespace havs::test {
namespace {

GlCalls calls;
std::map<std::pair<GLenum, GLuint>, std::string> labels;
GLuint programInUse = 0;

std::string labelOf(GLenum type, GLuint id) {
  const auto found = labels.find({type, id});
  return found == labels.end() ? "without a label" : found->second;
}

std::size_t bytesPerTexel(GLenum format) {
  switch (format) {
    case GL_RGBA32F:
      return 16;
    case GL_RGBA16UI:
    case GL_RGBA16F:
    case GL_RGBA16:
      return 8;
    case GL_RGBA8:
    case GL_R32F:
      return 4;
    case GL_STENCIL_INDEX8:
      return 1;
    default:
      throw std::runtime_error("gl_calls.cpp does not know the texture format " + std::to_string(format));
  }
}

void takeTexture(GLuint id, GLenum format, GLsizei width, GLsizei height, GLsizei depth) {
  const std::string label = labelOf(GL_TEXTURE, id);
  calls.textures.insert(label);
  calls.bytes[label] += bytesPerTexel(format) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                        static_cast<std::size_t>(depth);
}

void upload(GLenum type, GLuint id) { calls.uploads.insert(labelOf(type, id)); }

void countDraw() { ++calls.draws[labelOf(GL_PROGRAM, programInUse)]; }

/// What is noted of a call before it is made.
template <auto& kPointer>
struct Seen;

#define HAVS_SEEN(function, ...)   \
  template <>                      \
  struct Seen<glad_##function> {   \
    static void note(__VA_ARGS__); \
  };                               \
  void Seen<glad_##function>::note(__VA_ARGS__)

HAVS_SEEN(glObjectLabel, GLenum type, GLuint id, GLsizei length, const GLchar* text) {
  labels[{type, id}] = std::string(text, static_cast<std::size_t>(length));
}
HAVS_SEEN(glCompileShader, GLuint) { ++calls.shaders; }
HAVS_SEEN(glLinkProgram, GLuint id) { calls.programs.insert(labelOf(GL_PROGRAM, id)); }
HAVS_SEEN(glUseProgram, GLuint id) { programInUse = id; }
HAVS_SEEN(glTextureStorage1D, GLuint id, GLsizei, GLenum format, GLsizei width) {
  takeTexture(id, format, width, 1, 1);
}
HAVS_SEEN(glTextureStorage2D, GLuint id, GLsizei, GLenum format, GLsizei width, GLsizei height) {
  takeTexture(id, format, width, height, 1);
}
HAVS_SEEN(glTextureStorage3D, GLuint id, GLsizei, GLenum format, GLsizei width, GLsizei height, GLsizei depth) {
  takeTexture(id, format, width, height, depth);
}
HAVS_SEEN(glTextureBuffer, GLuint id, GLenum, GLuint) { calls.textures.insert(labelOf(GL_TEXTURE, id)); }
HAVS_SEEN(glNamedBufferStorage, GLuint id, GLsizeiptr size, const void*, GLbitfield) {
  const std::string label = labelOf(GL_BUFFER, id);
  calls.buffers.insert(label);
  calls.bytes[label] += static_cast<std::size_t>(size);
}
HAVS_SEEN(glTextureSubImage1D, GLuint id, GLint, GLint, GLsizei, GLenum, GLenum, const void*) {
  upload(GL_TEXTURE, id);
}
HAVS_SEEN(glTextureSubImage2D, GLuint id, GLint, GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, const void*) {
  upload(GL_TEXTURE, id);
}
HAVS_SEEN(glTextureSubImage3D, GLuint id, GLint, GLint, GLint, GLint, GLsizei, GLsizei, GLsizei, GLenum, GLenum,
          const void*) {
  upload(GL_TEXTURE, id);
}
HAVS_SEEN(glNamedBufferSubData, GLuint id, GLintptr, GLsizeiptr, const void*) { upload(GL_BUFFER, id); }
HAVS_SEEN(glMapNamedBufferRange, GLuint id, GLintptr, GLsizeiptr, GLbitfield) { upload(GL_BUFFER, id); }
HAVS_SEEN(glDrawArrays, GLenum, GLint, GLsizei) { countDraw(); }
HAVS_SEEN(glDrawElements, GLenum, GLsizei, GLenum, const void*) { countDraw(); }
#undef HAVS_SEEN

/// Puts a counting function in the place of glad's pointer; its return puts the pointer back.
template <auto& kPointer, class Result, class... Arguments>
std::function<void()> exchange(Result (*)(Arguments...)) {
  static Result (*original)(Arguments...) = nullptr;
  original = kPointer;
  kPointer = [](Arguments... arguments) -> Result {
    Seen<kPointer>::note(arguments...);
    return original(arguments...);
  };
  return [] { kPointer = original; };
}

/// The same for what is only counted, by its name.
template <auto& kPointer, class Result, class... Arguments>
std::function<void()> exchangeOther(const char* name, Result (*)(Arguments...)) {
  static Result (*original)(Arguments...) = nullptr;
  static std::string called;
  original = kPointer;
  called = name;
  kPointer = [](Arguments... arguments) -> Result {
    calls.others.insert(called);
    return original(arguments...);
  };
  return [] { kPointer = original; };
}

std::vector<std::function<void()>> restorers;

#define HAVS_COUNT(function) restorers.push_back(exchange<glad_##function>(glad_##function))
#define HAVS_COUNT_OTHER(function) restorers.push_back(exchangeOther<glad_##function>(#function, glad_##function))

void countOthers() {
  HAVS_COUNT_OTHER(glTexImage1D);
  HAVS_COUNT_OTHER(glTexImage2D);
  HAVS_COUNT_OTHER(glTexImage3D);
  HAVS_COUNT_OTHER(glTexSubImage1D);
  HAVS_COUNT_OTHER(glTexSubImage2D);
  HAVS_COUNT_OTHER(glTexSubImage3D);
  HAVS_COUNT_OTHER(glTexStorage1D);
  HAVS_COUNT_OTHER(glTexStorage2D);
  HAVS_COUNT_OTHER(glTexStorage3D);
  HAVS_COUNT_OTHER(glTexBuffer);
  HAVS_COUNT_OTHER(glTexBufferRange);
  HAVS_COUNT_OTHER(glTextureBufferRange);
  HAVS_COUNT_OTHER(glBufferData);
  HAVS_COUNT_OTHER(glBufferSubData);
  HAVS_COUNT_OTHER(glBufferStorage);
  HAVS_COUNT_OTHER(glNamedBufferData);
  HAVS_COUNT_OTHER(glCopyBufferSubData);
  HAVS_COUNT_OTHER(glCopyNamedBufferSubData);
  HAVS_COUNT_OTHER(glMapBuffer);
  HAVS_COUNT_OTHER(glMapBufferRange);
  HAVS_COUNT_OTHER(glMapNamedBuffer);
  HAVS_COUNT_OTHER(glRenderbufferStorage);
  HAVS_COUNT_OTHER(glNamedRenderbufferStorage);
  HAVS_COUNT_OTHER(glCreateShaderProgramv);
  HAVS_COUNT_OTHER(glProgramBinary);
  HAVS_COUNT_OTHER(glShaderBinary);
  HAVS_COUNT_OTHER(glUseProgramStages);
  HAVS_COUNT_OTHER(glDispatchCompute);
  HAVS_COUNT_OTHER(glDrawArraysInstanced);
  HAVS_COUNT_OTHER(glDrawElementsInstanced);
  HAVS_COUNT_OTHER(glDrawRangeElements);
  HAVS_COUNT_OTHER(glDrawArraysIndirect);
  HAVS_COUNT_OTHER(glDrawElementsIndirect);
  HAVS_COUNT_OTHER(glMultiDrawArrays);
  HAVS_COUNT_OTHER(glMultiDrawElements);
}

}  // namespace

bool GlCalls::madeNothing() const {
  return programs.empty() && shaders == 0 && textures.empty() && buffers.empty() && uploads.empty() && others.empty();
}

GlCallCounter::GlCallCounter() {
  calls = {};
  labels.clear();
  HAVS_COUNT(glObjectLabel);
  HAVS_COUNT(glCompileShader);
  HAVS_COUNT(glLinkProgram);
  HAVS_COUNT(glUseProgram);
  HAVS_COUNT(glTextureStorage1D);
  HAVS_COUNT(glTextureStorage2D);
  HAVS_COUNT(glTextureStorage3D);
  HAVS_COUNT(glTextureBuffer);
  HAVS_COUNT(glNamedBufferStorage);
  HAVS_COUNT(glTextureSubImage1D);
  HAVS_COUNT(glTextureSubImage2D);
  HAVS_COUNT(glTextureSubImage3D);
  HAVS_COUNT(glNamedBufferSubData);
  HAVS_COUNT(glMapNamedBufferRange);
  HAVS_COUNT(glDrawArrays);
  HAVS_COUNT(glDrawElements);
  countOthers();
}

GlCallCounter::~GlCallCounter() {
  for (const auto& restore : restorers) restore();
  restorers.clear();
}

GlCalls GlCallCounter::take() { return std::exchange(calls, {}); }

}  // namespace havs::test
