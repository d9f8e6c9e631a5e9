#include "image/background.h"

#include "core/error.h"
#include "image/color_names.h"

namespace havs {
namespace {

constexpr const char* kBetweenColors = "..";

Color colorOf(const std::string& part, const std::string& text) {
  const auto color = parseColor(part);
  if (!color)
    failInput("not a background: '" + text + "'", "",
              "try none, BOTTOM..TOP, '#rrggbb', r,g,b with numbers from 0 to 1, or a name: " + colorNames());
  return *color;
}

}  // namespace

Color Background::at(int row, int height) const {
  const double up = 1 - (row + 0.5) / height;
  Color color;
  for (std::size_t c = 0; c < 3; ++c) color[c] = bottom[c] + up * (top[c] - bottom[c]);
  return color;
}

std::optional<Background> parseBackground(const std::string& text) {
  if (text == "none") return std::nullopt;
  const std::size_t between = text.find(kBetweenColors);
  if (between == std::string::npos) return Background{colorOf(text, text)};
  return Background{colorOf(text.substr(0, between), text), colorOf(text.substr(between + 2), text)};
}

}  // namespace havs
