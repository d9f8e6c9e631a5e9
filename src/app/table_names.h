#pragma once
// What the command line asks of every table of methods (a span of rows with `name` and `description`).
#include <algorithm>
#include <string>
#include <vector>

#include "mesh/read.h"

namespace havs {

template <class Rows>
std::vector<std::string> namesOf(const Rows& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) names.push_back(row.name);
  return names;
}

/// One line a row, name and description, to stand below an option's help.
template <class Rows>
std::string rowsForHelp(const Rows& rows) {
  std::size_t width = 0;
  for (const auto& row : rows) width = std::max(width, row.name.size());
  std::string text;
  for (const auto& row : rows)
    text += "\n  " + row.name + std::string(width - row.name.size() + 2, ' ') + row.description;
  return text;
}

/// All file extensions that meshes are read from: ".node .ele .vtu ...".
inline std::string meshExtensions() {
  std::string text;
  for (const MeshFormat& format : meshFormats())
    for (const std::string& extension : format.extensions) text += (text.empty() ? "" : " ") + extension;
  return text;
}

}  // namespace havs
