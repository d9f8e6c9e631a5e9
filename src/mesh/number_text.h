#pragma once
#include <charconv>
#include <cstdlib>
#include <string>
#include <string_view>
#include <type_traits>

namespace havs {

/// from_chars over a whole word; it knows no plus sign and gives no value for 1e-400 or 1e400. False: no number.
template <class Number>
bool parseNumber(std::string_view word, Number& value) {
  const std::string_view digits = word.substr(word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0);
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (stop != digits.data() + digits.size()) return false;
  if constexpr (std::is_floating_point_v<Number>) {
    if (error == std::errc::result_out_of_range) {
      value = static_cast<Number>(std::strtod(std::string(digits).c_str(), nullptr));
      return true;
    }
  }
  return error == std::errc{};
}

}  // namespace havs
