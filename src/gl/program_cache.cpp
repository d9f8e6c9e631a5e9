#include "gl/program_cache.h"

namespace havs {

const Program& ProgramCache::get(const std::string& vertex, const std::string& fragment, const ShaderOptions& options) {
  const Key key{vertex, fragment, options.defines, options.extensions, options.standsFor};
  if (const auto found = programs_.find(key); found != programs_.end()) return found->second;
  // A vertex shader knows nothing of extensions for fragments, and some compilers refuse them there.
  Program program(vertex + " + " + fragment, {{GL_VERTEX_SHADER, shaderSource(vertex, {options.defines, {}})},
                                              {GL_FRAGMENT_SHADER, shaderSource(fragment, options)}});
  return programs_.emplace(key, std::move(program)).first->second;
}

}  // namespace havs
