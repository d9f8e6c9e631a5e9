#pragma once
#include <filesystem>

namespace havs {

/// The two files of a PLOT3D data set.
struct Plot3dPair {
  std::filesystem::path grid;
  std::filesystem::path solution;  ///< empty: there is none
};

/// The pair of `file`, the grid or the solution. The other's name has q in place of xyz (or the extension .q in place
/// of .xyz, .x, .g, .grd, .p3d), in either case: bluntfinxyz.bin, bluntfinq.bin. `solution`, where given, is taken
/// instead. Throws Error{input}: no such solution file; a solution without its grid.
Plot3dPair plot3dPair(const std::filesystem::path& file, const std::filesystem::path& solution);

}  // namespace havs
