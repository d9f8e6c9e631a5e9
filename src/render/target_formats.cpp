#include "render/target_formats.h"

#include "core/find_row.h"

namespace havs {

std::span<const TargetFormat> targetFormats() {
  static const std::vector<TargetFormat> rows{
      {"32f", "32-bit floats", "target_32f.glsl", 16, false},
      {"16f", "half floats, to see what they lose: distances and opacities in steps of 5e-4", "target_16f.glsl", 8,
       true},
  };
  return rows;
}

const TargetFormat& targetFormat(const std::string& name) { return findRow(targetFormats(), name, "target format"); }

}  // namespace havs
