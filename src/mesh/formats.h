#pragma once
// The readers and writers behind the table of formats (read.cpp): one function each, in the file named beside it. The
// path is known to be a file that exists and is not empty, or a directory entry of the same stem (.node for .ele). All
// throw Error{input} for broken content and Error{running} for failures of the machine.
#include <filesystem>

#include "mesh/read.h"
#include "mesh/tet_mesh.h"

namespace havs {

/// TetGen's .node and .ele; `file` names either (node_ele_reader.cpp).
TetMesh readNodeEle(const std::filesystem::path& file, const ReadOptions& options);
/// AVS UCD, ASCII .inp (ucd_reader.cpp).
TetMesh readUcd(const std::filesystem::path& file, const ReadOptions& options);
/// The VTK family, through the module that is opened on demand (vtk/). Only with HAVS_WITH_VTK.
TetMesh readWithVtk(const std::filesystem::path& file, const ReadOptions& options);
/// .vtu: the usual ones by all threads (vtu/vtu_reader.h), others as readWithVtk. Only with HAVS_WITH_VTK.
TetMesh readVtu(const std::filesystem::path& file, const ReadOptions& options);
/// PLOT3D grid and solution, through the same module (vtk/vtk_formats.cpp). Only with HAVS_WITH_PLOT3D, which comes
/// with HAVS_WITH_VTK.
TetMesh readPlot3d(const std::filesystem::path& file, const ReadOptions& options);
/// A surface (.poly .smesh .stl .off .ply) filled by TetGen (tetgen.cmake lists the sources). Only with
/// HAVS_WITH_TETGEN.
TetMesh tetrahedralise(const std::filesystem::path& file, const ReadOptions& options);

/// Writes `stem`.node and `stem`.ele beside it (node_ele_writer.cpp).
void writeNodeEle(const TetMesh& mesh, const std::filesystem::path& file);
/// Writes a VTK XML unstructured grid (vtk/). Only with HAVS_WITH_VTK.
void writeVtu(const TetMesh& mesh, const std::filesystem::path& file);

}  // namespace havs
