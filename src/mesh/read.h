#pragma once
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/progress.h"
#include "mesh/tet_mesh.h"

namespace havs {

struct ReadOptions {
  std::filesystem::path plot3dSolution;  ///< PLOT3D's q file; empty: found beside the xyz file by name
  std::string tetgenSwitches = "pq";     ///< for surfaces: TetGen's switches; Q (quiet) is added
  std::size_t maxTetrahedra = 0;         ///< 0: no limit
  Progress progress;
};

/// One row of the table of formats: adding a format is adding a row (and the file that reads it).
struct MeshFormat {
  std::string name;                     ///< "TetGen mesh"
  std::vector<std::string> extensions;  ///< lower case with dot: ".node"
  std::string needs;                    ///< "" or the build option it needs ("VTK", "TetGen")
  std::function<TetMesh(const std::filesystem::path&, const ReadOptions&)> read;
};

/// All formats that this build reads.
std::span<const MeshFormat> meshFormats();

/// Reads a mesh of any known format, chosen by the file's extension. Bit-identical points are welded, and it is noted.
/// Throws Error{input}: no such file, a directory, an empty file, an unknown extension (names the known ones), a format
/// that this build leaves out, broken content with file and line or cell, no tetrahedra, more than
/// options.maxTetrahedra.
TetMesh readMesh(const std::filesystem::path& file, const ReadOptions& options = {});

/// Writes .vtu (needs VTK) or .node with its .ele, by extension; whole or not at all. In TetGen's files the components
/// of all point data become attributes of the points, the first cell field of one component the region attribute; names
/// and further cell fields have no place there. Throws Error{input} for a name that cannot be written, Error{running}
/// when the disk refuses.
void writeMesh(const TetMesh& mesh, const std::filesystem::path& file);

}  // namespace havs
