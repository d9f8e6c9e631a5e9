// Faces are numbered by their first cells: a mesh whose cells lie in memory as they do in space (mesh/spatial_order.h)
// has its faces so, too.
#include "mesh/faces.h"

#include <algorithm>
#include <string>

#include "core/error.h"
#include "core/parallel.h"
#include "mesh/face_matching.h"

namespace havs {
namespace {

constexpr std::size_t kBlock = 4096;
constexpr Index kIsMate = Index{1} << 31;  ///< mark of a number that is still the mate's, not the face's

/// Whether the face between cell c and its mate is numbered by c.
bool isFirst(std::size_t c, Index mate) { return mate == kNoIndex || (mate >> 2) > c; }

/// How many faces the cells of each block number, as the number of each block's first face; all of them as last entry.
std::vector<std::size_t> firstFaces(const std::vector<std::array<Index, 4>>& mates) {
  const std::size_t blocks = (mates.size() + kBlock - 1) / kBlock;
  std::vector<std::size_t> first(blocks + 1, 0);
  parallelFor(0, blocks, 1, [&](std::size_t block) {
    const std::size_t end = std::min(mates.size(), (block + 1) * kBlock);
    for (std::size_t c = block * kBlock; c < end; ++c)
      for (const Index mate : mates[c]) first[block + 1] += isFirst(c, mate) ? 1 : 0;
  });
  for (std::size_t block = 0; block < blocks; ++block) first[block + 1] += first[block];
  return first;
}

/// Turns the mates of ofCell into numbers of faces and writes the faces.
void numberFaces(const TetMesh& mesh, const std::vector<std::size_t>& firstFace, Faces& faces) {
  const std::size_t cells = mesh.tetrahedra.size();
  parallelFor(0, firstFace.size() - 1, 1, [&](std::size_t block) {
    const std::size_t end = std::min(cells, (block + 1) * kBlock);
    std::size_t number = firstFace[block];
    for (std::size_t c = block * kBlock; c < end; ++c)
      for (std::size_t i = 0; i < 4; ++i) {
        Index& entry = faces.ofCell[c][i];
        if (!isFirst(c, entry)) {
          entry |= kIsMate;
          continue;
        }
        faces.vertices[number] = outwardFace(mesh.tetrahedra[c], i);
        faces.cells[number] = {static_cast<Index>(c), entry == kNoIndex ? kNoIndex : entry >> 2};
        entry = static_cast<Index>(number++);
      }
  });
  parallelFor(0, cells, kBlock, [&](std::size_t c) {
    for (Index& entry : faces.ofCell[c]) {
      const Index mate = entry & ~kIsMate;
      if ((entry & kIsMate) != 0) entry = faces.ofCell[mate >> 2][mate & 3u];
    }
  });
}

}  // namespace

Faces buildFaces(const TetMesh& mesh) {
  const std::size_t cellCount = mesh.tetrahedra.size();
  if (cellCount >= kIsMate / 4)
    failInput("a mesh of " + std::to_string(cellCount) + " tetrahedra has more faces than can be numbered", "",
              "use fewer than " + std::to_string(kIsMate / 4));
  Faces faces;
  FaceMates mates = matchFaces(mesh);
  faces.ofCell = std::move(mates.of);
  faces.plain = mates.plain;
  const std::vector<std::size_t> firstFace = firstFaces(faces.ofCell);
  const std::size_t faceCount = firstFace.back();
  faces.vertices.resize(faceCount);
  faces.cells.resize(faceCount);
  numberFaces(mesh, firstFace, faces);
  // Every inner face takes two of the cells' faces, every boundary face one.
  faces.boundaryCount = 2 * faceCount - 4 * cellCount;
  return faces;
}

}  // namespace havs
