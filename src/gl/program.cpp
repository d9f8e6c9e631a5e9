#include "gl/program.h"

#include "core/error.h"
#include "gl/check.h"

namespace havs {

namespace {

void deleteShader(GLuint id) { glDeleteShader(id); }
using ShaderHandle = Handle<deleteShader>;

std::string shaderLog(GLuint id) {
  GLint length = 0;
  glGetShaderiv(id, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  glGetShaderInfoLog(id, length, &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  return log;
}

std::string programLog(GLuint id) {
  GLint length = 0;
  glGetProgramiv(id, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  glGetProgramInfoLog(id, length, &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  return log;
}

ShaderHandle compile(const std::string& label, const Program::Stage& stage) {
  ShaderHandle shader(glCreateShader(stage.type));
  setLabel(GL_SHADER, shader.id(), label);
  const char* text = stage.source.text.c_str();
  glShaderSource(shader.id(), 1, &text, nullptr);
  glCompileShader(shader.id());
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
  if (!compiled) {
    const std::string log = shaderLog(shader.id());
    if (log.find_first_not_of(" \n") == std::string::npos)  // a driver without memory
      failRunning("shader does not compile, and the driver does not say why", label,
                  "raise the limit of memory (ulimit -v), or try --device native");
    failRunning("shader does not compile: " + explainLog(log, stage.source), label);
  }
  return shader;
}

}  // namespace

Program::Program(const std::string& label, const std::vector<Stage>& stages) : handle_(glCreateProgram()) {
  setLabel(GL_PROGRAM, id(), label);
  std::vector<ShaderHandle> shaders;
  for (const Stage& stage : stages) {
    shaders.push_back(compile(label, stage));
    glAttachShader(id(), shaders.back().id());
  }
  glLinkProgram(id());
  for (const ShaderHandle& shader : shaders) glDetachShader(id(), shader.id());
  GLint linked = GL_FALSE;
  glGetProgramiv(id(), GL_LINK_STATUS, &linked);
  if (!linked) failRunning("program does not link: " + explainLog(programLog(id()), {}), label);
  checkGl("linking program '" + label + "'");
}

}  // namespace havs
