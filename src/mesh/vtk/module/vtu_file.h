#pragma once
#include "mesh/tet_mesh.h"

namespace havs {

/// Writes the mesh as a VTK XML unstructured grid, appended, compressed by zlib. Throws std::runtime_error.
void writeVtuFile(const TetMesh& mesh, const char* file);

}  // namespace havs
