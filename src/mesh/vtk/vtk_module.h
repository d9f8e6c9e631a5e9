#pragma once
// What havs and its VTK module, a library of its own, know of each other. The module is opened in a child process
// (vtk_formats.cpp), so nothing of VTK is ever loaded into havs itself. No exception crosses the border.
#include <string>

#include "mesh/tet_mesh.h"
#include "mesh/vtk/grid_blocks.h"

namespace havs {

/// Takes what the module finds in a file.
class GridSink {
 public:
  virtual ~GridSink() = default;
  virtual void add(CellSoup&& cells) = 0;
  virtual void add(StructuredBlock&& grid) = 0;
  virtual void note(const std::string& text) = 0;
  /// Bytes that a mesh may take.
  virtual std::size_t memoryLimit() const = 0;
  /// What is wrong with the file: one phrase. Nothing that was added before counts then.
  virtual void fail(const std::string& what) = 0;
};

/// What to read.
struct GridRequest {
  std::string file;
  std::string solution;  ///< PLOT3D's q file, empty: none
  bool plot3d = false;   ///< `file` is a PLOT3D grid, else its extension tells the format
};

/// Takes the module's one phrase when writing fails.
struct WriteFailure {
  std::string what;
};

// The module's entry points, found by these names.
inline constexpr const char* kReadGridsSymbol = "havsVtkReadGrids";
inline constexpr const char* kWriteVtuSymbol = "havsVtkWriteVtu";
using ReadGridsFunction = void (*)(const GridRequest*, GridSink*);
using WriteVtuFunction = void (*)(const TetMesh*, const char* file, WriteFailure*);

}  // namespace havs
