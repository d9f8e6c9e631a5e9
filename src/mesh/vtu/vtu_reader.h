#pragma once
#include <filesystem>
#include <optional>

#include "mesh/tet_mesh.h"

namespace havs {

/// Reads a .vtu of tetrahedra alone, as nearly all writers write it (vtu_layout.h), by all threads and without VTK: the
/// same mesh, bit for bit, as VTK's reader gives. Nothing for every other file, and for a broken one: VTK can read the
/// one and say what is wrong with the other.
std::optional<TetMesh> readPlainVtu(const std::filesystem::path& file);

}  // namespace havs
