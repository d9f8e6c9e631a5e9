#pragma once
#include <optional>
#include <span>
#include <string>

#include "image/image.h"

namespace havs {

/// A colour that has a name.
struct NamedColor {
  std::string name;
  Color color;
};
std::span<const NamedColor> namedColors();

/// A name of namedColors(), "#rrggbb", or "r,g,b" with numbers from 0 to 1; empty for any other text.
std::optional<Color> parseColor(const std::string& text);

/// "white, black, ...", for messages and help.
std::string colorNames();

}  // namespace havs
