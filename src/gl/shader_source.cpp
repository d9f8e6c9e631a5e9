#include "gl/shader_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "core/error.h"
#include "core/nearest_name.h"

namespace havs {

namespace {

std::string readFromFolder(const std::string& folder, const std::string& name, const std::string& where) {
  std::ifstream file(folder + "/" + name, std::ios::binary);
  if (!file) failRunning("no shader '" + name + "' in the folder HAVS_SHADERS=" + folder, where, "unset HAVS_SHADERS");
  return {std::istreambuf_iterator<char>(file), {}};
}

/// `where`: the line that asks for it.
std::string textOf(const std::string& name, const std::string& where) {
  const char* folder = std::getenv("HAVS_SHADERS");
  if (folder && *folder) return readFromFolder(folder, name, where);
  std::vector<std::string> names;
  for (const EmbeddedShader& shader : embeddedShaders()) {
    if (shader.name == name) return shader.text;
    names.emplace_back(shader.name);
  }
  failRunning("no shader '" + name + "'", where, didYouMean(name, names));
}

class Expansion {
 public:
  explicit Expansion(const ShaderOptions& options) : standsFor_(options.standsFor) {
    std::string header = "#version 450 core\n";
    for (const std::string& extension : options.extensions) header += "#extension " + extension + " : require\n";
    for (const auto& [name, value] : options.defines) header += "#define " + name + " " + value + "\n";
    source_.text = header;
    source_.files.push_back({"(defines)", header});
  }

  void add(const std::string& name, const std::string& text) {
    const std::size_t number = source_.files.size();
    source_.files.push_back({name, text});
    const auto mark = [&](int line) { source_.text += fmt::format("#line {} {}\n", line, number); };
    mark(1);
    static const std::regex kInclude(R"(\s*#\s*include\s+"([^"]+)\".*)");
    std::istringstream lines(text);
    std::smatch match;
    std::string line;
    for (int i = 1; std::getline(lines, line); ++i) {
      if (line == "#pragma once") line.clear();  // for C++; here every file is included once
      if (line.find("include") == std::string::npos || !std::regex_match(line, match, kInclude)) {
        source_.text += line + "\n";
        continue;
      }
      const auto stand = standsFor_.find(match[1]);
      const std::string included = stand == standsFor_.end() ? match[1].str() : stand->second;
      if (!has(included)) add(included, textOf(included, fmt::format("{}:{}", name, i)));
      mark(i + 1);
    }
  }

  ShaderSource take() { return std::move(source_); }

 private:
  bool has(const std::string& name) const {
    return std::any_of(source_.files.begin(), source_.files.end(), [&](const auto& file) { return file.name == name; });
  }

  const std::map<std::string, std::string>& standsFor_;
  ShaderSource source_;
};

std::string lineOf(const std::string& text, int number) {
  std::istringstream lines(text);
  std::string line;
  for (int i = 0; i < number && std::getline(lines, line); ++i) {
  }
  const std::size_t begin = line.find_first_not_of(" \t");
  return begin == std::string::npos ? "" : line.substr(begin);
}

}  // namespace

ShaderSource shaderSource(const std::string& name, const ShaderOptions& options) {
  return shaderSourceFromText(name, textOf(name, ""), options);
}

ShaderSource shaderSourceFromText(const std::string& name, const std::string& text, const ShaderOptions& options) {
  Expansion expansion(options);
  expansion.add(name, text);
  return expansion.take();
}

std::string explainLog(const std::string& log, const ShaderSource& source) {
  // Mesa and Intel: "2:14(7): error: ..."; NVIDIA: "2(14) : error ...".
  static const std::regex kPlace(R"((\d{1,4})[:(](\d{1,6})[)(:][\d)]*\s*:?\s*(.*))");
  constexpr int kShown = 3;
  std::istringstream lines(log);
  std::string explained, line;
  std::smatch match;
  for (int shown = 0; shown < kShown && std::getline(lines, line);) {
    if (line.empty()) continue;
    if (std::regex_match(line, match, kPlace) && std::stoul(match[1]) < source.files.size()) {
      const ShaderSource::File& file = source.files[std::stoul(match[1])];
      line = fmt::format("{}:{}: {} in '{}'", file.name, match[2].str(), match[3].str(),
                         lineOf(file.text, std::stoi(match[2])));
    }
    explained += (explained.empty() ? "" : " | ") + line;
    ++shown;
  }
  return explained;
}

}  // namespace havs
