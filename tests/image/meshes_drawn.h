#pragma once
// The meshes that pictures are compared on.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mesh/tet_mesh.h"

namespace havs::test {

struct MeshDrawn {
  std::string name;
  int size;                                      ///< of the picture, pixels a side
  std::function<std::optional<TetMesh>()> make;  ///< with a field; nothing where this machine or build has not got it
};
inline void PrintTo(const MeshDrawn& mesh, std::ostream* stream) { *stream << mesh.name; }

/// Made ones, TetGen's, and real ones.
std::vector<MeshDrawn> meshesDrawn();

}  // namespace havs::test
