#pragma once
// How the values of options that are texts on the command line are written in scene files: one form a kind.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace havs {

struct Form {
  using Json = nlohmann::ordered_json;
  const char* needed;  ///< for messages
  Json schema;
  /// As the command line has it; empty where the value is of another kind. `folder`: the scene file's.
  std::optional<std::string> (*toText)(const Json& value, const std::filesystem::path& folder);
  Json (*fromText)(const std::string& text, const std::filesystem::path& folder);
};

extern const Form kText, kFile, kTransferFunction, kSize, kRange, kRangeOrNone, kSixNumbers, kBackground, kCamera,
    kCountOrAuto, kSettings, kIsosurface, kStyle;

}  // namespace havs
