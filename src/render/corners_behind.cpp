#include "render/corners_behind.h"

#include "core/parallel.h"

namespace havs {
namespace {

Index cornerBehind(const PreparedScene& prepared, Index cell, Index face) {
  if (cell == kNoIndex) return kNoIndex;
  const auto& faces = prepared.faces.ofCell[cell];
  for (std::size_t i = 0; i < 4; ++i)
    if (faces[i] == face) return prepared.mesh.tetrahedra[cell][i];
  return kNoIndex;
}

}  // namespace

std::vector<std::array<Index, 2>> cornersBehindFaces(const PreparedScene& prepared) {
  std::vector<std::array<Index, 2>> corners(prepared.faces.size());
  parallelFor(0, corners.size(), 16384, [&](std::size_t f) {
    const auto& [behindFront, behindBack] = prepared.faces.cells[f];
    const auto face = static_cast<Index>(f);
    corners[f] = {cornerBehind(prepared, behindFront, face), cornerBehind(prepared, behindBack, face)};
  });
  return corners;
}

}  // namespace havs
