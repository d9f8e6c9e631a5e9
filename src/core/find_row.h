#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/nearest_name.h"

namespace havs {

/// The row of a table of methods with this name. `what`: what the rows are, for the message ("lookup"); `where`: the
/// option. Throws Error{input} for an unknown name, naming the nearest.
template <class Row>
const Row& findRow(std::span<const Row> rows, const std::string& name, const std::string& what,
                   const std::string& where = "") {
  std::vector<std::string> names;
  for (const Row& row : rows) {
    if (row.name == name) return row;
    names.push_back(row.name);
  }
  failInput("unknown " + what + " '" + name + "'", where, didYouMean(name, names));
}

}  // namespace havs
