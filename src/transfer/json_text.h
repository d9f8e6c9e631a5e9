#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/error.h"

namespace havs {

/// Lists and objects that stand in each other: copying, comparing and printing JSON calls itself for each, and the
/// stack of a thread is 8 MiB. What we read nests 5 deep at most.
inline constexpr int kDeepestJson = 100;

/// Whether more than kDeepestJson brackets are open at once.
inline bool nestsTooDeep(std::string_view text) {
  int depth = 0;
  bool inText = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inText) {
      i += c == '\\' ? 1 : 0;
      inText = c != '"';
    } else if (c == '[' || c == '{') {
      if (++depth > kDeepestJson) return true;
    } else {
      inText = c == '"';
      depth -= c == ']' || c == '}' ? 1 : 0;
    }
  }
  return false;
}

/// Parses JSON text; is_discarded() where it is none, or nests too deep.
template <class Json>
Json parsedOrDiscarded(std::string_view text) {
  return nestsTooDeep(text) ? Json(Json::value_t::discarded) : Json::parse(text.begin(), text.end(), nullptr, false);
}

/// Parses JSON text; throws Error{input} with line and column.
template <class Json>
Json parseJson(std::string_view text, const std::string& file) {
  if (nestsTooDeep(text))
    failInput("lists and objects stand more than " + std::to_string(kDeepestJson) + " deep in each other", file,
              "nothing that is read here does");
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
