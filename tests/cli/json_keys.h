#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace havs::test {

inline std::vector<std::string> keysOf(const nlohmann::json& object) {
  std::vector<std::string> keys;
  for (const auto& item : object.items()) keys.push_back(item.key());
  return keys;
}

}  // namespace havs::test
