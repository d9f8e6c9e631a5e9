#include "mesh/vtk/plot3d_names.h"

#include <array>
#include <string_view>

#include "core/error.h"

namespace havs {
namespace fs = std::filesystem;
namespace {

bool isFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// `file` with the last `from` of its name replaced by `to`, if such a file exists.
fs::path renamed(const fs::path& file, std::string_view from, std::string_view to) {
  std::string name = file.filename().string();
  const std::size_t at = name.rfind(from);
  if (at == std::string::npos) return {};
  name.replace(at, from.size(), to);
  const fs::path other = file.parent_path() / name;
  return isFile(other) ? other : fs::path();
}

constexpr std::array<std::array<std::string_view, 2>, 2> kStems{{{"xyz", "q"}, {"XYZ", "Q"}}};
constexpr std::array<std::string_view, 5> kGridExtensions{".xyz", ".x", ".g", ".grd", ".p3d"};

fs::path solutionOf(const fs::path& grid) {
  for (const auto& [xyz, q] : kStems)
    if (const fs::path found = renamed(grid, xyz, q); !found.empty()) return found;
  for (const char* extension : {".q", ".Q"})
    if (const fs::path found = fs::path(grid).replace_extension(extension); found != grid && isFile(found))
      return found;
  return {};
}

fs::path gridOf(const fs::path& solution) {
  for (const auto& [xyz, q] : kStems)
    if (const fs::path found = renamed(solution, q, xyz); !found.empty()) return found;
  for (const std::string_view extension : kGridExtensions)
    if (const fs::path found = fs::path(solution).replace_extension(extension); isFile(found)) return found;
  return {};
}

bool namesSolution(const fs::path& file) {
  const std::string stem = file.stem().string(), extension = file.extension().string();
  if (extension == ".q" || extension == ".Q") return true;
  return extension == ".bin" && (stem.ends_with('q') || stem.ends_with('Q'));
}

}  // namespace

Plot3dPair plot3dPair(const fs::path& file, const fs::path& solution) {
  if (!solution.empty()) {
    if (!isFile(solution)) failInput("no such PLOT3D q file", solution.string());
    return {file, solution};
  }
  if (!namesSolution(file)) return {file, solutionOf(file)};
  const fs::path grid = gridOf(file);
  if (grid.empty())
    failInput("is a PLOT3D solution without its grid", file.string(), "name the xyz file, and the q file with --q");
  return {grid, file};
}

}  // namespace havs
