#include "gl/check.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <utility>

#include "core/error.h"

namespace havs {

namespace {

constexpr std::size_t kMaxMessages = 8;

void GLAD_API_PTR collect(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text,
                          const void* user) {
  if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
  auto& messages = static_cast<DebugLog*>(const_cast<void*>(user))->messages;
  if (messages.size() >= kMaxMessages) return;
  std::string message(text, length < 0 ? std::char_traits<char>::length(text) : static_cast<std::size_t>(length));
  while (!message.empty() && (message.back() == '\n' || message.back() == '\0')) message.pop_back();
  messages.push_back(std::move(message));
}

std::string errorName(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    default:
      return fmt::format("OpenGL error {:#x}", error);
  }
}

// The context itself knows its log, so that checkGl() needs neither the device nor a global.
DebugLog* currentLog() {
  void* user = nullptr;
  glGetPointerv(GL_DEBUG_CALLBACK_USER_PARAM, &user);
  return static_cast<DebugLog*>(user);
}

}  // namespace

std::unique_ptr<DebugLog> startDebugLog() {
  auto log = std::make_unique<DebugLog>();
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(collect, log.get());
  return log;
}

void checkGl(std::string_view doing) {
  std::string errors;
  bool outOfMemory = false;
  // A lost context returns errors for ever.
  for (int i = 0; i < 8; ++i) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) break;
    outOfMemory = outOfMemory || error == GL_OUT_OF_MEMORY;
    errors += (errors.empty() ? "" : ", ") + errorName(error);
  }
  DebugLog* log = currentLog();
  const std::vector<std::string> messages = log ? std::exchange(log->messages, {}) : std::vector<std::string>();
  if (outOfMemory) {
    failRunning(fmt::format("OpenGL ran out of memory {}", doing), "", "try a smaller --size, --k or --table");
  }
  if (errors.empty() && messages.empty()) return;
  failRunning(fmt::format("OpenGL failed {}: {}", doing, messages.empty() ? errors : messages.front()));
}

}  // namespace havs
