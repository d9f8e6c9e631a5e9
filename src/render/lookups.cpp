#include "render/lookups.h"

#include "core/find_row.h"

namespace havs {

std::span<const Lookup> lookups() {
  static const std::vector<Lookup> rows{
      {"3d", "pre-integrated table over front scalar, back scalar and length (the paper's)", "lookup/table_3d.glsl",
       LookupTable::table3d},
      {"post", "transfer function at both ends, trapezoid between them (post-classification)", "lookup/post.glsl",
       LookupTable::curve},
      {"pre", "colour and extinction at the vertices, linear between them (projected tetrahedra)", "lookup/pre.glsl",
       LookupTable::none, Payload::color},
  };
  return rows;
}

std::span<const TableFormat> tableFormats() {
  static const std::vector<TableFormat> rows{
      {"rgba32f", "32-bit float, filtered by the texture unit", 16, false},
      {"rgba8", "8 bits a channel (the paper's), filtered in the shader", 4, true},
  };
  return rows;
}

const Lookup& lookup(const std::string& name) { return findRow(lookups(), name, "lookup"); }
const TableFormat& tableFormat(const std::string& name) { return findRow(tableFormats(), name, "table format"); }

}  // namespace havs
