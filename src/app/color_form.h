#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace havs {

/// A colour of a scene file, a text or [r, g, b], as an option has it; empty for anything else.
std::optional<std::string> colorToText(const nlohmann::ordered_json& value);
/// And back: r,g,b as a list. The text itself where it is no three numbers: what is wrong with it is said when it is
/// read.
nlohmann::ordered_json colorFromText(const std::string& text);
/// Its schema.
nlohmann::ordered_json colorSchema();

/// A background of a scene file: a colour, {"bottom": colour, "top": colour}, or null for none; and back, r,g,b as a
/// list. Empty for anything else.
std::optional<std::string> backgroundToText(const nlohmann::ordered_json& value);
nlohmann::ordered_json backgroundFromText(const std::string& text);
nlohmann::ordered_json backgroundSchema();

}  // namespace havs
