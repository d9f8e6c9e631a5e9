// Geomview's OFF, ASCII: the word OFF, counts of points, faces and edges, the points, then the faces as corners p0 p1
// ... [colour].
#include <fmt/format.h>

#include <cmath>

#include "mesh/tetgen_surface.h"
#include "mesh/text_scanner.h"

namespace havs {

Surface readOffSurface(const std::filesystem::path& file) {
  TextScanner in(file);
  in.needLine("the word OFF");
  if (in.word("the word OFF") != "OFF") in.fail("this is no OFF file: it does not start with the word OFF");
  if (!in.more()) in.needLine("the counts of points and faces");
  const std::size_t points = in.count("points", 6);
  const std::size_t faces = in.count("faces", 4);

  Surface surface;
  surface.points.reserve(points);
  for (std::size_t i = 0; i < points; ++i) {
    in.needLine(fmt::format("point {} of {}", i + 1, points));
    const double x = in.real("x");
    const double y = in.real("y");
    const double z = in.real("z");
    in.refuseDecimalCommas();
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
      in.fail("the point has a coordinate that is not finite", "correct it");
    surface.points.emplace_back(x, y, z);
  }
  surface.facets.resize(faces);
  for (std::size_t i = 0; i < faces; ++i) {
    in.needLine(fmt::format("face {} of {}", i + 1, faces));
    std::vector<int> corners(in.count("corners", 2));
    if (corners.size() < 3) in.fail(fmt::format("a face has {} corners", corners.size()), "it needs at least 3");
    for (int& corner : corners) {
      const std::int64_t number = in.integer("a corner's point number");
      if (number < 0 || number >= static_cast<std::int64_t>(points))
        in.fail(fmt::format("a face has the point number {}, out of range: the points are 0 to {}", number,
                            static_cast<std::int64_t>(points) - 1),
                "correct it");
      corner = static_cast<int>(number);
    }
    surface.facets[i].polygons.push_back(std::move(corners));
  }
  return surface;
}

}  // namespace havs
