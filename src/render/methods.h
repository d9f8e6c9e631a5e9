#pragma once
#include <span>
#include <string>
#include <vector>

namespace havs {

/// One row of the table of visibility methods (`--visibility`).
struct VisibilityMethod {
  std::string name;
  std::string description;
  std::vector<std::string> extensions;  ///< any one of them is needed; empty: none
  int maximumK = 0;
};
std::span<const VisibilityMethod> visibilityMethods();

/// One row of the table of lookups (`--lookup`).
struct Lookup {
  std::string name;
  std::string description;
  std::string shader;  ///< file below shaders/lookup/ that defines lookUp()
};
std::span<const Lookup> lookups();

}  // namespace havs
