#include "mesh/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/error.h"
#include "core/nearest_name.h"
#include "mesh/defects.h"
#include "mesh/formats.h"

namespace havs {
namespace {
namespace fs = std::filesystem;

/// A format that is known, whether or not this build can read it.
struct Row {
  MeshFormat format;
  bool built;
};

#ifdef HAVS_WITH_VTK
constexpr bool kWithVtk = true;
const auto kReadWithVtk = readWithVtk;
const auto kReadVtu = readVtu;
#else
constexpr bool kWithVtk = false;
const auto kReadWithVtk = nullptr;
const auto kReadVtu = nullptr;
#endif
#ifdef HAVS_WITH_PLOT3D
constexpr bool kWithPlot3d = true;
const auto kReadPlot3d = readPlot3d;
#else
constexpr bool kWithPlot3d = false;
const auto kReadPlot3d = nullptr;
#endif
#ifdef HAVS_WITH_TETGEN
constexpr bool kWithTetgen = true;
const auto kTetrahedralise = tetrahedralise;
#else
constexpr bool kWithTetgen = false;
const auto kTetrahedralise = nullptr;
#endif

const std::vector<Row>& allFormats() {
  static const std::vector<Row> rows = {
      {{"TetGen mesh", {".node", ".ele"}, "", readNodeEle}, true},
      {{"AVS UCD", {".inp"}, "", readUcd}, true},
      {{"VTK legacy", {".vtk"}, "VTK", kReadWithVtk}, kWithVtk},
      {{"VTK unstructured grid", {".vtu", ".pvtu"}, "VTK", kReadVtu}, kWithVtk},
      {{"VTK structured grids", {".vti", ".vts", ".vtr"}, "VTK", kReadWithVtk}, kWithVtk},
      {{"Exodus", {".ex2", ".exo", ".e"}, "VTK", kReadWithVtk}, kWithVtk},
      {{"EnSight", {".case"}, "VTK", kReadWithVtk}, kWithVtk},
      {{"CGNS", {".cgns"}, "VTK", kReadWithVtk}, kWithVtk},
      {{"PLOT3D", {".xyz", ".bin", ".x", ".p3d", ".fmt", ".g"}, "VTK", kReadPlot3d}, kWithPlot3d},
      {{"surface for TetGen", {".poly", ".smesh", ".stl", ".off", ".ply"}, "TetGen", kTetrahedralise}, kWithTetgen},
  };
  return rows;
}

std::string extensionOf(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

std::vector<std::string> knownExtensions() {
  std::vector<std::string> all;
  for (const MeshFormat& format : meshFormats())
    all.insert(all.end(), format.extensions.begin(), format.extensions.end());
  return all;
}

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : " ") + name;
  return list;
}

const MeshFormat& formatOf(const fs::path& file) {
  const std::string extension = extensionOf(file);
  const std::string known = listed(knownExtensions());
  if (extension.empty())
    failInput("the file's name has no extension, so its format is not known", file.string(), "known: " + known);
  for (const Row& row : allFormats()) {
    const auto& extensions = row.format.extensions;
    if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end()) continue;
    if (!row.built)
      failInput(fmt::format("a {} file ({}) needs {}, and this build was made without {}", row.format.name, extension,
                            row.format.needs, row.format.needs),
                file.string(),
                fmt::format("build it in with -DHAVS_WITH_{}=ON", row.format.needs == "VTK" ? "VTK" : "TETGEN"));
    return row.format;
  }
  failInput(fmt::format("'{}' is no extension of a known format", extension), file.string(),
            fmt::format("did you mean '{}'? known: {}", nearestName(extension, knownExtensions()), known));
}

/// Files beside the missing one whose names begin like it ("bluntfin" -> "bluntfinxyz.bin"), else advice.
std::string namesLike(const fs::path& file) {
  std::vector<std::string> names;
  std::error_code ignored;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!file.filename().empty() && name.starts_with(file.stem().string())) names.push_back(name);
  }
  if (names.empty()) return "check the path";
  std::sort(names.begin(), names.end());
  return fmt::format("did you mean {}?", fmt::join(names, " or "));
}

void checkFile(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (file.empty()) failInput("the mesh file's name is empty", "", "name a mesh file");
  if (!fs::exists(status))
    failInput(error && status.type() != fs::file_type::not_found ? error.message() : std::string("no such file"),
              file.string(), namesLike(file));
  if (fs::is_directory(status)) failInput("this is a directory", file.string(), "name a mesh file in it");
  if (!fs::is_regular_file(status)) failInput("this is no regular file", file.string(), "name a mesh file");
  if (fs::file_size(file, error) == 0) failInput("the file is empty", file.string(), "write it again");
}

}  // namespace

std::span<const MeshFormat> meshFormats() {
  static const std::vector<MeshFormat> formats = [] {
    std::vector<MeshFormat> built;
    for (const Row& row : allFormats())
      if (row.built) built.push_back(row.format);
    return built;
  }();
  return formats;
}

TetMesh readMesh(const fs::path& file, const ReadOptions& options) {
  checkFile(file);
  const MeshFormat& format = formatOf(file);
  TetMesh mesh = format.read(file, options);
  if (mesh.tetrahedra.empty()) failInput("the file holds no tetrahedra", file.string(), "a volume needs solid cells");
  if (options.maxTetrahedra > 0 && mesh.tetrahedra.size() > options.maxTetrahedra)
    failInput(fmt::format("{} tetrahedra are more than the limit of {}", mesh.tetrahedra.size(), options.maxTetrahedra),
              file.string(), "raise the limit or make a coarser mesh");
  if (const std::size_t welded = weldPoints(mesh); welded > 0)
    mesh.notes.push_back(fmt::format("welded {} points that were identical to others", welded));
  return mesh;
}

void writeMesh(const TetMesh& mesh, const fs::path& file) {
  const std::string extension = extensionOf(file);
  if (extension == ".node" || extension == ".ele") return writeNodeEle(mesh, file);
#ifdef HAVS_WITH_VTK
  if (extension == ".vtu") return writeVtu(mesh, file);
#else
  if (extension == ".vtu")
    failInput("writing .vtu needs VTK, and this build was made without VTK", file.string(),
              "write .node, or build with -DHAVS_WITH_VTK=ON");
#endif
  failInput(fmt::format("'{}' is no format that meshes are written in", extension), file.string(),
            "name a .vtu, .node or .ele file");
}

}  // namespace havs
