#include "mesh/tetgen_switches.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string_view>

#include "core/error.h"

namespace havs {
namespace {

/// What may follow a switch: up to `numbers` numbers with a slash between them, each within its range.
struct Switch {
  char letter;
  int numbers;
  double lowest[2], highest[2];
};

constexpr double kMost = 1e300;
constexpr double kLeast = 1e-300;

constexpr Switch kSwitches[] = {
    {'p', 1, {0, 0}, {180, 0}},         // fill the surface; angle below which facets count as one
    {'Y', 1, {0, 0}, {2, 0}},           // keep the surface's triangles
    {'q', 2, {1, 0}, {100, 60}},        // quality: radius to edge, smallest dihedral angle. Below 1 there may be no end
    {'a', 1, {kLeast, 0}, {kMost, 0}},  // largest volume
    {'A', 0, {0, 0}, {0, 0}},           // attributes of regions
    {'O', 2, {0, 0}, {10, 7}},          // optimise: level, operations
    {'S', 1, {0, 0}, {INT32_MAX, 0}},   // most points to add
    {'T', 1, {0, 0}, {1e-3, 0}},        // tolerance of coplanarity
    {'M', 2, {0, 0}, {7, 7}},           // do not merge facets
    {'R', 0, {0, 0}, {0, 0}},           // coarsen
    {'J', 0, {0, 0}, {0, 0}},           // leave no point out
    {'X', 0, {0, 0}, {0, 0}},           // no exact arithmetic
    {'C', 0, {0, 0}, {0, 0}},           // check the mesh
    {'c', 0, {0, 0}, {0, 0}},           // keep the convex hull
    {'D', 1, {0, 0}, {7, 0}},           // conforming Delaunay
    {'V', 0, {0, 0}, {0, 0}},           // verbose
    {'Q', 0, {0, 0}, {0, 0}},           // quiet: it always is
};

std::string knownLetters() {
  std::string letters;
  for (const Switch& known : kSwitches) letters += fmt::format("{}{}", letters.empty() ? "" : " ", known.letter);
  return letters;
}

bool startsNumber(std::string_view text) {
  return !text.empty() && ((text[0] >= '0' && text[0] <= '9') || text[0] == '.');
}

/// Takes the number at the front of `text`.
void takeNumber(std::string_view& text, const Switch& known, int which, const std::string& where) {
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool right = error == std::errc{} && value >= known.lowest[which] && value <= known.highest[which];
  if (!right)
    failInput(fmt::format("the number after {} is none from {:g} to {:g}", known.letter, known.lowest[which],
                          known.highest[which]),
              where, "correct it");
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
}

void takeNumbers(std::string_view& text, const Switch& known, const std::string& where) {
  for (int which = 0; which < known.numbers; ++which) {
    if (which == 1 && !text.starts_with('/')) return;
    if (which == 1) text.remove_prefix(1);
    if (startsNumber(text)) takeNumber(text, known, which, where);
  }
}

}  // namespace

std::string tetgenCommand(const std::string& switches) {
  constexpr std::size_t kLongest = 200;
  const std::string where = "TetGen's switches '" + switches.substr(0, kLongest) + "'";
  if (switches.size() > kLongest) failInput("they are too long", where);
  std::string_view text = switches;
  if (text.starts_with('-')) text.remove_prefix(1);
  std::string command(text);
  while (!text.empty()) {
    const auto known = std::ranges::find(kSwitches, text[0], &Switch::letter);
    if (known == std::end(kSwitches))
      failInput(fmt::format("'{}' is no switch that fills a surface with linear tetrahedra", text[0]), where,
                "known: " + knownLetters());
    text.remove_prefix(1);
    takeNumbers(text, *known, where);
  }
  std::erase(command, 'Q');
  if (command.find('p') == std::string::npos) command += 'p';
  return command;
}

}  // namespace havs
