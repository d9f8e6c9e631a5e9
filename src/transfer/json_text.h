#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/error.h"

namespace havs {

/// Parses JSON text; throws Error{input} with line and column.
template <class Json>
Json parseJson(std::string_view text, const std::string& file) {
  try {
    return Json::parse(text.begin(), text.end());
  } catch (const nlohmann::json::exception& error) {
    std::string what = error.what();  // "[json.exception.parse_error.101] parse error at line 3, column 7: ..."
    const std::size_t bracket = what.find("] ");
    failInput(bracket == std::string::npos ? what : what.substr(bracket + 2), file, "it is no valid JSON");
  }
}

/// A value as a message quotes it: numbers, texts and the like as they stand, lists and objects by their kind.
template <class Json>
std::string quoted(const Json& value) {
  return value.is_structured() ? value.type_name() : value.dump();
}

}  // namespace havs
