#pragma once
// Every lookup as a test's parameter.
#include <cctype>
#include <string>
#include <vector>

#include "render/lookups.h"

namespace havs::test {

inline std::vector<std::string> lookupNames() {
  std::vector<std::string> names;
  for (const Lookup& row : lookups()) names.push_back(exampleName(row));
  return names;
}

/// Those that read a table whose size and format can be chosen.
inline std::vector<std::string> namesOfLookupsWithTables() {
  std::vector<std::string> names;
  for (const Lookup& row : lookups())
    if (tableOf(row) != nullptr) names.push_back(exampleName(row));
  return names;
}

/// A name as GoogleTest takes it.
inline std::string testName(std::string name) {
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

}  // namespace havs::test
