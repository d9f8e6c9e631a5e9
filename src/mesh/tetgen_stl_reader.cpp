// STL. Binary: 80 bytes of anything, the number of triangles, 50 bytes for each (normal, three corners, two bytes).
// ASCII: words, of which only "vertex x y z" matters. A binary file may start with the word solid, too: its size tells.
#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "mesh/tetgen_binary_file.h"
#include "mesh/tetgen_surface.h"
#include "mesh/text_scanner.h"
#include "mesh/weld.h"

namespace havs {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kTriangleBytes = 50;

/// The corners, three for each triangle.
using Corners = std::vector<Vec3>;

Corners readBinary(BinaryFile& in, std::size_t triangles) {
  constexpr std::size_t kNormalBytes = 12, kAttributeBytes = 2;
  Corners corners;
  corners.reserve(3 * triangles);
  for (std::size_t i = 0; i < triangles; ++i) {
    in.skip(kNormalBytes, "a triangle");
    for (int corner = 0; corner < 3; ++corner) {
      const double x = in.get<float>("x");
      const double y = in.get<float>("y");
      const double z = in.get<float>("z");
      corners.emplace_back(x, y, z);
    }
    in.skip(kAttributeBytes, "a triangle");
  }
  return corners;
}

Corners readAscii(const fs::path& file) {
  TextScanner in(file);
  in.needLine("the word solid");
  if (in.word("the word solid") != "solid")
    in.fail("this is no STL file: no word solid at its start, nor the size of a binary one", "is it cut short?");
  Corners corners;
  bool ended = false;
  while (in.nextLine()) {
    const std::string_view word = in.word("a word");
    if (word == "endsolid") ended = true;
    if (word == "endfacet" && corners.size() % 3 != 0) in.fail("a facet has not three corners", "STL holds triangles");
    if (word != "vertex") continue;
    const double x = in.real("x");
    const double y = in.real("y");
    corners.emplace_back(x, y, in.real("z"));
  }
  if (!ended || corners.size() % 3 != 0) in.fail("the file ends without endsolid", "is it cut short?");
  return corners;
}

Corners readCorners(const fs::path& file) {
  BinaryFile in(file);
  in.setBigEndian(false);
  if (in.left() < kHeaderBytes + sizeof(std::uint32_t)) return readAscii(file);
  in.skip(kHeaderBytes, "the header");
  const std::size_t triangles = in.get<std::uint32_t>("the number of triangles");
  return in.left() == triangles * kTriangleBytes ? readBinary(in, triangles) : readAscii(file);
}

}  // namespace

Surface readStlSurface(const fs::path& file) {
  Surface surface;
  surface.points = readCorners(file);
  const std::size_t corners = surface.points.size();
  if (corners == 0) failInput("holds no triangles", file.string());
  for (std::size_t i = 0; i < corners; ++i)
    if (const Vec3& p = surface.points[i]; !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      failInput("a corner has a coordinate that is not finite", fmt::format("{}, triangle {}", file.string(), i / 3));
  const std::vector<Index> number = mergeIdenticalPoints(surface.points, surface.pointFields);
  const auto point = [&](std::size_t i) { return static_cast<int>(number.empty() ? i : number[i]); };
  std::size_t flat = 0;
  for (std::size_t i = 0; i < corners; i += 3) {
    std::vector<int> triangle{point(i), point(i + 1), point(i + 2)};
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
      ++flat;
    else
      surface.facets.push_back({{std::move(triangle)}, {}, 0});
  }
  if (flat > 0) surface.notes.push_back(fmt::format("left out {} triangles with identical corners", flat));
  return surface;
}

}  // namespace havs
