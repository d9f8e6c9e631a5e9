#pragma once
// The tables of methods (docs/06-add-a-method.md). The command line, --help and the plan go through these rows.
#include <cstddef>
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
/// Throws Error{input}, naming the nearest.
const VisibilityMethod& visibilityMethod(const std::string& name);

/// What a lookup reads besides the segment.
enum class LookupTable {
  curve,   ///< the transfer function itself, sampled along the scalar: colour and extinction
  table3d  ///< the pre-integrated table over (front scalar, back scalar, length)
};

/// One row of the table of lookups (`--lookup`).
struct Lookup {
  std::string name;
  std::string description;
  std::string shader;  ///< file below shaders/ that defines lookUp(Segment)
  LookupTable table;
};
std::span<const Lookup> lookups();
/// Throws Error{input}, naming the nearest.
const Lookup& lookup(const std::string& name);

/// One row of the table of number formats of the 3D table (`--table-format`).
struct TableFormat {
  std::string name;
  std::string description;
  std::size_t bytesPerEntry = 0;
  bool eightBits = false;  ///< unsigned normalised bytes, which the shader filters itself; else floats
};
std::span<const TableFormat> tableFormats();
/// Throws Error{input}, naming the nearest.
const TableFormat& tableFormat(const std::string& name);

}  // namespace havs
