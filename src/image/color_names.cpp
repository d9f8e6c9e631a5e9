#include "image/color_names.h"

#include <charconv>

namespace havs {
namespace {

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

std::span<const NamedColor> namedColors() {
  static const std::vector<NamedColor> rows{{"white", {1, 1, 1}},   {"black", {0, 0, 0}},   {"gray", {0.5, 0.5, 0.5}},
                                            {"red", {1, 0, 0}},     {"green", {0, 1, 0}},   {"blue", {0, 0, 1}},
                                            {"cyan", {0, 1, 1}},    {"magenta", {1, 0, 1}}, {"yellow", {1, 1, 0}},
                                            {"orange", {1, 0.5, 0}}};
  return rows;
}

std::optional<Color> parseColor(const std::string& text) {
  for (const NamedColor& row : namedColors())
    if (row.name == text) return row.color;
  return text.starts_with('#') ? hexColor(std::string_view(text).substr(1)) : decimalColor(text);
}

std::string colorNames() {
  std::string names;
  for (const NamedColor& row : namedColors()) names += (names.empty() ? "" : ", ") + row.name;
  return names;
}

}  // namespace havs
