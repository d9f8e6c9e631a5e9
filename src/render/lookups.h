#pragma once
// The tables of lookups and of the number formats of their tables (docs/06-add-a-method.md).
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace havs {

/// What a lookup reads besides the segment.
enum class LookupTable {
  none,    ///< nothing
  curve,   ///< the transfer function itself, sampled along the scalar: colour and extinction
  table3d  ///< the pre-integrated table over (front scalar, back scalar, length)
};

/// What the fragments of a picture carry besides their distance and kind.
enum class Payload {
  scalar,
  color  ///< colour and extinction, evaluated at the vertices (cell data: of the cell)
};

/// One row of the table of lookups (`--lookup`).
struct Lookup {
  std::string name;
  std::string description;
  std::string shader;  ///< file below shaders/ that defines lookUp(Segment)
  LookupTable table;
  Payload carries = Payload::scalar;  ///< what it needs of the fragments
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
