// study.csv and effects.csv: what study.json says of runs and effects, as tables.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "study/records_json.h"
#include "study/study_report.h"

namespace havs {
namespace {

using Json = nlohmann::ordered_json;

std::string csvField(const Json& value) {
  std::string text = value.is_string() ? value.get<std::string>() : value.is_null() ? "" : textOf(value);
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  for (std::size_t i = 0; (i = text.find('"', i)) != std::string::npos; i += 2) text.insert(i, "\"");
  return "\"" + text + "\"";
}

/// Numbers as "1x2", texts with semicolons.
std::string cellOf(const Json& array) {
  if (array.empty()) return "";
  const char* const separator = array.at(0).is_string() ? "; " : "x";
  std::string text;
  for (const Json& value : array)
    text += (text.empty() ? "" : separator) + (value.is_string() ? value.get<std::string>() : textOf(value));
  return text;
}

/// A JSON object as columns "a.b". Lists of objects are left to study.json.
void flatten(const Json& json, const std::string& prefix, std::vector<std::pair<std::string, Json>>& columns) {
  for (const auto& [key, value] : json.items()) {
    if (value.is_object())
      flatten(value, prefix + key + ".", columns);
    else if (value.is_array() && !value.empty() && value.at(0).is_object())
      continue;
    else if (value.is_array())
      columns.emplace_back(prefix + key, cellOf(value));
    else
      columns.emplace_back(prefix + key, value);
  }
}

/// One row an object, with a header; missing values are empty.
std::string tableOf(const Json& objects) {
  std::vector<std::string> header;
  std::vector<std::map<std::string, std::string>> rows;
  for (const Json& object : objects) {
    std::vector<std::pair<std::string, Json>> columns;
    flatten(object, "", columns);
    auto& row = rows.emplace_back();
    for (const auto& [name, value] : columns) {
      row[name] = csvField(value);
      if (std::find(header.begin(), header.end(), name) == header.end()) header.push_back(name);
    }
  }
  std::string text = fmt::format("{}\n", fmt::join(header, ","));
  for (auto& row : rows) {
    for (std::size_t i = 0; i < header.size(); ++i) text += (i > 0 ? "," : "") + row[header[i]];
    text += "\n";
  }
  return text;
}

}  // namespace

std::string studyCsv(const StudyReport& report) { return tableOf(runsJson(report)); }

std::string effectsCsv(const StudyReport& report) { return tableOf(effectsJson(report)); }

}  // namespace havs
