#pragma once
// The text of a shader: files of shaders/, which are compiled into the program (cmake/HavsShaders.cmake), put together.
#include <map>
#include <span>
#include <string>
#include <vector>

namespace havs {

/// One file of shaders/, under its path below that folder.
struct EmbeddedShader {
  const char* name;
  const char* text;
};
std::span<const EmbeddedShader> embeddedShaders();

/// What one source is compiled with.
struct ShaderOptions {
  std::map<std::string, std::string> defines;  ///< name -> value, which may be empty
  std::vector<std::string> extensions;         ///< required ones: GL_EXT_shader_framebuffer_fetch
  /// Name in an `#include` -> the file that it stands for: how one of several files of a kind is chosen.
  std::map<std::string, std::string> standsFor;
};

/// A source ready to be compiled. `#line N F` in the text means line N of files[F].
struct ShaderSource {
  struct File {
    std::string name;
    std::string text;
  };
  std::string text;
  std::vector<File> files;
};

/// The shader of this name with every `#include "core/kbuffer.glsl"` (paths below shaders/) expanded, each file once,
/// behind
/// `#version 450 core`, the extensions and the defines. The environment variable HAVS_SHADERS names a folder to read
/// the files from instead, so that a shader can be changed without building. Throws Error{running} for a file that is
/// not there.
ShaderSource shaderSource(const std::string& name, const ShaderOptions& options = {});

/// The same for a text that is no file, `name` being what error messages call it.
ShaderSource shaderSourceFromText(const std::string& name, const std::string& text, const ShaderOptions& options = {});

/// A driver's log in terms of the files: the first errors, each as `core/kbuffer.glsl:12: error: ... in 'source line'`,
/// on one line.
std::string explainLog(const std::string& log, const ShaderSource& source);

}  // namespace havs
