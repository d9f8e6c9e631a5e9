#include "image/background.h"

#include <charconv>

#include "core/error.h"

namespace havs {
namespace {

[[noreturn]] void fail(const std::string& text) {
  failInput("not a background: '" + text + "'", "",
            "try white, black, none, '#rrggbb' or r,g,b with numbers from 0 to 1");
}

std::optional<Color> hexColor(std::string_view digits) {
  if (digits.size() != 6) return std::nullopt;
  Color color;
  for (std::size_t c = 0; c < 3; ++c) {
    int value = 0;
    const char* first = digits.data() + 2 * c;
    const auto [end, error] = std::from_chars(first, first + 2, value, 16);
    if (error != std::errc{} || end != first + 2 || value < 0) return std::nullopt;
    color[c] = value / 255.0;
  }
  return color;
}

std::optional<Color> decimalColor(std::string_view text) {
  Color color;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t c = 0; c < 3; ++c) {
    const auto [next, error] = std::from_chars(at, end, color[c]);
    if (error != std::errc{} || !(color[c] >= 0 && color[c] <= 1)) return std::nullopt;
    const bool separated = c == 2 ? next == end : next != end && *next == ',';
    if (!separated) return std::nullopt;
    at = next + 1;
  }
  return color;
}

}  // namespace

std::optional<Color> parseBackground(const std::string& text) {
  if (text == "none") return std::nullopt;
  if (text == "white") return Color{1, 1, 1};
  if (text == "black") return Color{0, 0, 0};
  const auto color = text.starts_with('#') ? hexColor(std::string_view(text).substr(1)) : decimalColor(text);
  if (!color) fail(text);
  return color;
}

}  // namespace havs
