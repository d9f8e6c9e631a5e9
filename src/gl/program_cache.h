#pragma once
#include <map>
#include <string>
#include <tuple>

#include "gl/program.h"
#include "gl/shader_source.h"

namespace havs {

/// Programs of shaders/ by their files and options, each compiled when it is first asked for.
class ProgramCache {
 public:
  /// `vertex`, `fragment`: names as shaderSource() takes them; both are compiled with `options`. The program lives as
  /// long as the cache. Throws what Program does.
  const Program& get(const std::string& vertex, const std::string& fragment, const ShaderOptions& options = {});
  std::size_t size() const { return programs_.size(); }

 private:
  using Key = std::tuple<std::string, std::string, std::map<std::string, std::string>, std::vector<std::string>,
                         std::map<std::string, std::string>>;
  std::map<Key, Program> programs_;
};

}  // namespace havs
