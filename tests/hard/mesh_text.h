#pragma once
// Meshes as text files of the formats that the hard cases read.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>

#include "mesh/tet_mesh.h"
#include "support/temporary_folder.h"

namespace havs::test {

/// Writes NAME.node, the first point field as attribute, and NAME.ele, every number to the last bit.
inline std::filesystem::path writeNodeEle(const TemporaryFolder& folder, const std::string& name, const TetMesh& mesh) {
  const std::vector<double>& values = mesh.pointFields.at(0).values;
  std::string node = fmt::format("{} 3 1 0\n", mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vec3& p = mesh.points[i];
    node += fmt::format("{} {} {} {} {}\n", i, p.x, p.y, p.z, values[i]);
  }
  std::string ele = fmt::format("{} 4 0\n", mesh.tetrahedra.size());
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i)
    ele += fmt::format("{} {}\n", i, fmt::join(mesh.tetrahedra[i], " "));
  folder.write(name + ".ele", ele);
  return folder.write(name + ".node", node);
}

}  // namespace havs::test
