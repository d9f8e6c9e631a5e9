#include "image/background.h"

#include "core/error.h"
#include "image/color_names.h"

namespace havs {

std::optional<Color> parseBackground(const std::string& text) {
  if (text == "none") return std::nullopt;
  const auto color = parseColor(text);
  if (!color)
    failInput("not a background: '" + text + "'", "",
              "try none, '#rrggbb', r,g,b with numbers from 0 to 1, or a name: " + colorNames());
  return color;
}

}  // namespace havs
