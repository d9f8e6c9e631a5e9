// Surfaces become volumes: read by own readers, which check every number, then filled by TetGen.
#include <algorithm>
#include <cctype>

#include "core/error.h"
#include "mesh/formats.h"
#include "mesh/tetgen_run.h"
#include "mesh/tetgen_switches.h"

namespace havs {
namespace {

Surface readSurface(const std::filesystem::path& file) {
  constexpr struct {
    const char* extension;
    Surface (*read)(const std::filesystem::path&);
  } kReaders[] = {{".poly", readPolySurface},
                  {".smesh", readPolySurface},
                  {".stl", readStlSurface},
                  {".off", readOffSurface},
                  {".ply", readPlySurface}};
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  for (const auto& reader : kReaders)
    if (extension == reader.extension) return reader.read(file);
  failInput("is no surface that TetGen fills", file.string(), "known: .poly .smesh .stl .off .ply");
}

}  // namespace

TetMesh tetrahedralise(const std::filesystem::path& file, const ReadOptions& options) {
  constexpr std::size_t kMost = 1u << 28;  // TetGen counts in int, some of its arrays in several times this
  const std::string command = tetgenCommand(options.tetgenSwitches);
  const Surface surface = readSurface(file);
  if (surface.points.size() < 4 || surface.facets.size() < 4)
    failInput("the surface encloses nothing", file.string(), "it takes at least 4 points and 4 facets");
  if (surface.points.size() > kMost || surface.facets.size() > kMost)
    failInput("the surface has more points or facets than TetGen can number", file.string(), "simplify it");
  return runTetgen(surface, command, file.string());
}

}  // namespace havs
