#pragma once
// The tables of lookups, of what they read, and of the number formats of their tables (docs/06-add-a-method.md).
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace havs {

struct ResourceInput;
struct ResourceData;

/// One row of the table of what shaders read besides the segment.
struct LookupResource {
  std::string name;
  std::string description;
  int axes = 0;         ///< of a table whose size and number format can be chosen; 0: no such table
  int largestSize = 0;  ///< entries along each axis, 2 at the least
  int ownSize = 0;      ///< of a table for which none is asked
  /// Entries of a table of that size.
  std::size_t entries(std::size_t size) const { return axes == 3 ? size * size * size : size * size; }
  /// Makes the tables and numbers (render/lookup_resources.h).
  ResourceData (*make)(const ResourceInput& input) = nullptr;
};
std::span<const LookupResource> lookupResources();
/// Throws Error{running}: rows name them, users do not.
const LookupResource& lookupResource(const std::string& name);

/// What the fragments of a picture carry besides their distance and kind.
enum class Payload {
  scalar,
  color,  ///< colour and extinction, evaluated at the vertices (cell data: of the cell)
  lit     ///< a scalar, the light that falls on it, and what the modulation leaves of its extinction
};

/// Numbers that a fragment carries besides these.
inline int numbersOf(Payload carries) { return carries == Payload::color ? 4 : carries == Payload::lit ? 3 : 1; }

/// One row of the table of lookups (`--lookup`).
struct Lookup {
  std::string name;  ///< of a chosen lookup with its number: "riemann:8"
  std::string description;
  std::string shader;                  ///< file below shaders/ that defines lookUp(Segment)
  std::vector<std::string> resources;  ///< rows of lookupResources() that the shader reads
  std::string parameter;               ///< what a number behind its name and a colon stands for; empty: takes none
  int number = 0;                      ///< that number, of a chosen lookup; lookupNumber in the shader
  Payload carries = Payload::scalar;   ///< what it needs of the fragments
};
/// The rows; a name ends with ":n" where a number belongs to it.
std::span<const Lookup> lookups();
/// The row of a name, its number read ("riemann:8"). Throws Error{input} for an unknown name, naming the nearest, and
/// for a number that is missing, not one, or not from 1 to 256.
Lookup lookup(const std::string& name);
/// A name that the row can be chosen by: its own, with the number 8 where it takes one.
std::string exampleName(const Lookup& row);
/// The table of a lookup whose size and format can be chosen; null where it has none.
const LookupResource* tableOf(const Lookup& lookup);

/// One row of the table of number formats of tables (`--table-format`).
struct TableFormat {
  std::string name;
  std::string description;
  std::size_t bytesPerEntry = 0;
  unsigned internalFormat = 0;  ///< OpenGL's name of it
  bool filteredInShader = false;
  /// A value of [0, 1] as the format holds it; null: as it is.
  float (*rounded)(float value) = nullptr;
};
std::span<const TableFormat> tableFormats();
/// Throws Error{input}, naming the nearest.
const TableFormat& tableFormat(const std::string& name);

}  // namespace havs
