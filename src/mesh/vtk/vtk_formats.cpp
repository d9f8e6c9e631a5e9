// The VTK family of formats. VTK's readers may print, leak, exit or crash on a broken file, and take long to load: the
// module with them is opened and run in a child process, which hands the grids back.
#include "core/error.h"
#include "core/output_file.h"
#include "mesh/formats.h"
#include "core/isolated.h"
#include "mesh/vtk/grid_wire.h"
#include "mesh/vtk/module_loader.h"
#include "mesh/vtk/plot3d_names.h"
#include "mesh/vtu/vtu_reader.h"

namespace havs {
namespace {

GridBlocks readGrids(const GridRequest& request) {
  IsolatedRun run = runIsolated([&](ByteWriter& out) {
    const auto read = reinterpret_cast<ReadGridsFunction>(vtkModuleSymbol(kReadGridsSymbol));
    GridWriter sink(out);
    read(&request, &sink);
    sink.finish(request.file);
  });
  if (!run.death.empty())
    failInput("cannot be read: VTK's reader breaks down on it (" + run.death + ")", request.file, "is the file whole?");
  return receiveGrids(run.reply);
}

}  // namespace

TetMesh readWithVtk(const std::filesystem::path& file, const ReadOptions&) {
  return meshFromBlocks(readGrids({.file = file.string()}), file.string());
}

TetMesh readVtu(const std::filesystem::path& file, const ReadOptions& options) {
  if (auto mesh = readPlainVtu(file)) return std::move(*mesh);
  return readWithVtk(file, options);
}

TetMesh readPlot3d(const std::filesystem::path& file, const ReadOptions& options) {
  const Plot3dPair pair = plot3dPair(file, options.plot3dSolution);
  GridBlocks blocks = readGrids({.file = pair.grid.string(), .solution = pair.solution.string(), .plot3d = true});
  blocks.notes.push_back(pair.solution.empty() ? "found no PLOT3D q file beside the grid: no fields"
                                               : "read the solution from " + pair.solution.string());
  return meshFromBlocks(std::move(blocks), pair.grid.string());
}

void writeVtu(const TetMesh& mesh, const std::filesystem::path& file) {
  OutputFile output(file);
  const IsolatedRun run = runIsolated([&](ByteWriter&) {
    const auto write = reinterpret_cast<WriteVtuFunction>(vtkModuleSymbol(kWriteVtuSymbol));
    WriteFailure failure;
    write(&mesh, output.temporary().c_str(), &failure);
    if (!failure.what.empty()) failRunning("writing failed: " + failure.what, file.string(), "is the disk full?");
  });
  if (!run.death.empty()) failRunning("VTK's writer broke down (" + run.death + ")", file.string());
  output.commit();
}

}  // namespace havs
