#include "study/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/error.h"
#include "core/find_row.h"
#include "render/lookups.h"
#include "render/plan.h"
#include "render/target_formats.h"
#include "render/visibility.h"
#include "sort/face_order.h"

namespace havs {
namespace {

using Values = std::vector<std::string>;

template <class Number>
Number parseNumber(const std::string& text, const char* what) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || last != end) failInput(fmt::format("'{}' is not {}", text, what));
  return value;
}

int parseInteger(const std::string& text) { return parseNumber<int>(text, "a whole number"); }

template <class Rows>
Values namesOf(const Rows& rows) {
  Values names;
  for (const auto& row : rows) names.push_back(row.name);
  return names;
}

/// Every lookup; one that takes a number with several of them, so that the order of its error can be seen.
Values lookupNames(bool quick) {
  Values names;
  for (const Lookup& row : lookups()) {
    const std::string example = exampleName(row);
    if (row.parameter.empty() || quick) {
      names.push_back(example);
      continue;
    }
    for (const char* number : {"1", "2", "4", "8", "16"})
      names.push_back(example.substr(0, example.find(':') + 1) + number);
  }
  return names;
}

bool always(const Scene&) { return true; }
bool readsTable(const Scene& scene) { return tableOf(lookup(scene.lookup)) != nullptr; }

/// The longer side; the other follows.
void applySize(Scene& scene, const std::string& value) {
  const int longer = parseInteger(value), before = std::max(scene.width, scene.height);
  if (longer < 1) failInput(fmt::format("a picture of {} pixels", longer));
  if (longer == before) return;
  auto scaled = [&](int side) {
    return std::max(1, static_cast<int>(std::lround(static_cast<double>(side) * longer / before)));
  };
  scene.width = scaled(scene.width);
  scene.height = scaled(scene.height);
}

StudyAxis kAxis() {
  return {.name = "k",
          .title = "Entries of the k-buffer",
          .ordered = true,
          .values =
              [](bool quick) {
                return quick ? Values{"1", "2", "6", "14"} : Values{"1", "2", "3", "4", "6", "8", "10", "14"};
              },
          .apply = [](Scene& s, const std::string& value) { s.k = parseInteger(value); },
          .valueOf = [](const Scene& s) { return std::to_string(s.k); },
          .applies = [](const Scene& s) { return visibilityMethod(s.visibility).maximumK > 0; }};
}

StudyAxis visibilityAxis() {
  return {.name = "visibility",
          .title = "How a pixel's fragments are ordered",
          .values = [](bool) { return namesOf(visibilityMethods()); },
          .apply = [](Scene& s, const std::string& value) { s.visibility = visibilityMethod(value).name; },
          .valueOf = [](const Scene& s) { return s.visibility; },
          .applies = always};
}

StudyAxis sortAxis() {
  return {.name = "sort",
          .title = "Order in which faces are drawn",
          .values = [](bool) { return namesOf(sortMethods()); },
          .apply = [](Scene& s, const std::string& value) { s.sort = sortMethod(value).name; },
          .valueOf = [](const Scene& s) { return s.sort; },
          .applies = [](const Scene& s) { return visibilityMethod(s.visibility).needsOrder; }};
}

StudyAxis lookupAxis() {
  return {.name = "lookup",
          .title = "How a segment's colour is found",
          .values = lookupNames,
          .apply = [](Scene& s, const std::string& value) { lookup(s.lookup = value); },
          .valueOf = [](const Scene& s) { return s.lookup; },
          .applies = always};
}

StudyAxis tableAxis() {
  return {.name = "table",
          .title = "Entries along each side of the table",
          .ordered = true,
          .across = "lookup",
          .values =
              [](bool quick) {
                return quick ? Values{"16", "32", "64"} : Values{"8", "16", "32", "64", "128"};
              },
          .apply = [](Scene& s, const std::string& value) { s.tableSize = parseInteger(value); },
          .valueOf = [](const Scene& s) { return std::to_string(tableSizeOf(s)); },
          .applies = readsTable};
}

StudyAxis tableFormatAxis() {
  return {.name = "table-format",
          .title = "Numbers of the table",
          .values = [](bool) { return namesOf(tableFormats()); },
          .apply = [](Scene& s, const std::string& value) { s.tableFormat = tableFormat(value).name; },
          .valueOf = [](const Scene& s) { return s.tableFormat; },
          .applies = readsTable};
}

StudyAxis targetFormatAxis() {
  return {.name = "target-format",
          .title = "Numbers of the k-buffer's targets",
          .values = [](bool) { return namesOf(targetFormats()); },
          .apply = [](Scene& s, const std::string& value) { s.targetFormat = targetFormat(value).name; },
          .valueOf = [](const Scene& s) { return s.targetFormat; },
          .applies = [](const Scene& s) { return visibilityMethod(s.visibility).maximumK > 0; }};
}

StudyAxis earlyTerminationAxis() {
  return {
      .name = "early-termination",
      .title = "Opacity at which a pixel is done (0: never)",
      .ordered = true,
      .values =
          [](bool quick) {
            return quick ? Values{"0", "0.99"} : Values{"0", "0.999", "0.99", "0.95", "0.9"};
          },
      .apply = [](Scene& s, const std::string& value) { s.earlyTermination = parseNumber<double>(value, "a number"); },
      .valueOf = [](const Scene& s) { return fmt::format("{}", s.earlyTermination); },
      .applies = [](const Scene& s) { return visibilityMethod(s.visibility).endsPixelsEarly; }};
}

StudyAxis sizeAxis() {
  return {.name = "size",
          .title = "Pixels along the longer side",
          .ordered = true,
          .changesPicture = true,
          .values =
              [](bool quick) {
                return quick ? Values{"128"} : Values{"128", "256", "512", "1024"};
              },
          .apply = applySize,
          .valueOf = [](const Scene& s) { return std::to_string(std::max(s.width, s.height)); },
          .applies = always};
}

std::string canonical(const StudyAxis& row, const std::string& value) {
  Scene scene;
  try {
    row.apply(scene, value);
  } catch (const Error& error) {
    failInput(error.what(), "--axis " + row.name);
  }
  return row.changesPicture ? value : row.valueOf(scene);
}

AxisChoice parseChoice(const std::string& text, bool quick) {
  const std::size_t equals = text.find('=');
  const StudyAxis& row = axis(text.substr(0, equals));
  AxisChoice choice{&row, {}};
  if (equals == std::string::npos) {
    choice.values = row.values(quick);
    return choice;
  }
  for (std::size_t begin = equals + 1; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string value = canonical(row, text.substr(begin, end - begin));
    if (std::find(choice.values.begin(), choice.values.end(), value) == choice.values.end())
      choice.values.push_back(value);
    begin = end + 1;
  }
  return choice;
}

}  // namespace

std::span<const StudyAxis> axes() {
  static const std::vector<StudyAxis> rows{kAxis(),     visibilityAxis(),  sortAxis(),         lookupAxis(),
                                           tableAxis(), tableFormatAxis(), targetFormatAxis(), earlyTerminationAxis(),
                                           sizeAxis()};
  return rows;
}

const StudyAxis& axis(const std::string& name) { return findRow(axes(), name, "axis", "--axis"); }

std::vector<AxisChoice> chooseAxes(std::span<const std::string> texts, bool quick) {
  std::vector<AxisChoice> choices;
  if (texts.empty())
    for (const StudyAxis& row : axes()) choices.push_back({&row, row.values(quick)});
  for (const std::string& text : texts) {
    AxisChoice choice = parseChoice(text, quick);
    for (const AxisChoice& other : choices)
      if (other.axis == choice.axis)
        failInput("is given twice", "--axis " + choice.axis->name, "list its values with commas");
    choices.push_back(std::move(choice));
  }
  return choices;
}

std::string settingsKey(const Scene& scene) {
  std::string key = scene.compositeLate ? "late" : "";
  for (const StudyAxis& row : axes())
    if (row.applies(scene)) key += "|" + row.name + "=" + row.valueOf(scene);
  return key;
}

std::string settingsLabel(const Scene& scene) {
  const VisibilityMethod& method = visibilityMethod(scene.visibility);
  std::string text = scene.visibility;
  if (method.maximumK > 0) text += fmt::format(" k {}", scene.k);
  if (method.needsOrder) text += ", " + scene.sort;
  text += ", " + scene.lookup;
  if (const LookupResource* table = tableOf(lookup(scene.lookup)))
    text += fmt::format(" {}^{} {}", tableSizeOf(scene), table->axes, scene.tableFormat);
  if (method.maximumK > 0 && scene.targetFormat != Scene{}.targetFormat)
    text += fmt::format(", targets {}", scene.targetFormat);
  if (scene.earlyTermination > 0) text += fmt::format(", ends at {}", scene.earlyTermination);
  if (scene.compositeLate) text += ", late composited";
  return text;
}

}  // namespace havs
