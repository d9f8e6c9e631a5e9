#pragma once
#include <fmt/core.h>

#include <nlohmann/json.hpp>

namespace havs {

/// Prints the object to standard output; bytes that are not UTF-8 (file names may hold any) are replaced.
inline void printJson(const nlohmann::ordered_json& json) {
  fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

}  // namespace havs
