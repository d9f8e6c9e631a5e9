#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/vec.h"
#include "mesh/tet_mesh.h"

namespace havs {

/// A flat piece of the surface: polygons in one plane, some of them holes of others, which `holes` mark by a point
/// each.
struct Facet {
  std::vector<std::vector<int>> polygons;
  std::vector<Vec3> holes;
  int marker = 0;
};

/// A seed of a part of the volume. `maxVolume` limits its tetrahedra under the switch -a without a number; <= 0: no
/// limit.
struct Region {
  Vec3 seed{0};
  double attribute = 0;
  double maxVolume = -1;
};

/// A piecewise linear complex: what TetGen fills with tetrahedra.
struct Surface {
  std::vector<Vec3> points;
  std::vector<Field> pointFields;
  std::vector<Facet> facets;
  std::vector<Vec3> holes;
  std::vector<Region> regions;
  std::vector<std::string> notes;
};

/// Readers by format. Point numbers are checked, and start at 0 in the result. Throw Error{input} with file and line
/// (or byte).
Surface readPolySurface(
    const std::filesystem::path& file);  ///< .poly and .smesh, points in the .node beside where it has none
Surface readStlSurface(const std::filesystem::path& file);  ///< ASCII and binary; identical corners become one point
Surface readOffSurface(const std::filesystem::path& file);  ///< Geomview's OFF, ASCII
Surface readPlySurface(const std::filesystem::path& file);  ///< ASCII and binary of either byte order

}  // namespace havs
