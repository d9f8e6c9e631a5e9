// TetGen's .poly and .smesh: points, facets, holes and regions, each part headed by its count. A .poly facet is
//   polygons [holes] [marker], then one line a polygon (corners p0 p1 ...), then one line a hole (number x y z);
// an .smesh facet is one polygon on one line: corners p0 p1 ... [marker]. Numbers start at 0 or at 1, as the first
// point's does.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mesh/tetgen_surface.h"
#include "mesh/text_scanner.h"

namespace havs {
namespace fs = std::filesystem;
namespace {

struct Numbering {
  std::int64_t first = 0;
  std::int64_t count = 0;
};

std::int64_t optionalInteger(TextScanner& in, const char* what, std::int64_t otherwise = 0) {
  return in.more() ? in.integer(what) : otherwise;
}

Vec3 readPosition(TextScanner& in) {
  const double x = in.real("x");
  const double y = in.real("y");
  const double z = in.real("z");
  return {x, y, z};
}

/// The points in `count` lines, and the number of the first of them.
std::int64_t readPointLines(TextScanner& in, std::size_t count, std::size_t attributes, bool markers,
                            Surface& surface) {
  std::int64_t first = 0;
  surface.points.reserve(count);
  for (std::size_t a = 0; a < attributes; ++a) surface.pointFields.push_back({fmt::format("attribute{}", a), 1, {}});
  for (std::size_t i = 0; i < count; ++i) {
    in.needLine(fmt::format("point {} of {}", i + 1, count));
    const std::int64_t number = in.integer("a point's number");
    if (i == 0) first = number;
    if (first != 0 && first != 1) in.fail(fmt::format("the first point's number is {}", first), "start at 0 or at 1");
    if (number != first + static_cast<std::int64_t>(i))
      in.fail(fmt::format("point number {} stands where {} is expected", number, first + static_cast<std::int64_t>(i)),
              "number them one after the other");
    surface.points.push_back(readPosition(in));
    if (const Vec3& p = surface.points.back(); !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      in.fail("the point has a coordinate that is not finite", "correct it");
    for (Field& field : surface.pointFields) field.values.push_back(in.real("an attribute"));
    if (markers) optionalInteger(in, "a boundary marker");
    in.refuseDecimalCommas();
  }
  return first;
}

/// The header and lines of points; no points at all when they are in a file of their own.
Numbering readPoints(TextScanner& in, Surface& surface) {
  constexpr std::int64_t kMostAttributes = 1000;
  in.needLine("the header of the points");
  const std::size_t count = in.count("points", 8);  // "0 0 0 0\n" is the shortest line
  const std::int64_t dimension = optionalInteger(in, "the dimension", 3);
  const std::int64_t attributes = optionalInteger(in, "the number of attributes");
  const std::int64_t markers = optionalInteger(in, "the number of boundary markers");
  if (dimension != 3) in.fail(fmt::format("the points have {} dimensions", dimension), "a volume needs 3");
  if (attributes < 0 || attributes > kMostAttributes)
    in.fail(fmt::format("the number of attributes is {}", attributes),
            fmt::format("0 to {} are read", kMostAttributes));
  const std::int64_t first = readPointLines(in, count, static_cast<std::size_t>(attributes), markers > 0, surface);
  return {first, static_cast<std::int64_t>(count)};
}

Numbering readPointsBeside(const fs::path& file, Surface& surface) {
  fs::path node = file;
  TextScanner in(node.replace_extension(".node"));
  const Numbering numbering = readPoints(in, surface);
  if (numbering.count == 0) in.fail("there are no points", "a surface needs some");
  return numbering;
}

std::vector<int> readPolygon(TextScanner& in, const Numbering& points) {
  std::vector<int> corners(in.count("corners", 2));  // corners may go on over several lines
  if (corners.empty()) in.fail("a polygon has no corners", "give it at least 1");
  for (int& corner : corners) {
    if (!in.more()) in.needLine("a polygon's next corner");
    const std::int64_t number = in.integer("a corner's point number");
    if (number < points.first || number >= points.first + points.count)
      in.fail(fmt::format("a polygon has the point number {}, out of range: the points are {} to {}", number,
                          points.first, points.first + points.count - 1),
              "correct it");
    corner = static_cast<int>(number - points.first);
  }
  return corners;
}

Facet readPolyFacet(TextScanner& in, bool markers, const Numbering& points) {
  Facet facet;
  const std::size_t polygons = in.count("polygons", 2);
  const std::size_t holes = in.more() ? in.count("holes in the facet", 6) : 0;
  if (markers) facet.marker = static_cast<int>(optionalInteger(in, "a boundary marker"));
  for (std::size_t i = 0; i < polygons; ++i) {
    in.needLine(fmt::format("polygon {} of {}", i + 1, polygons));
    facet.polygons.push_back(readPolygon(in, points));
  }
  for (std::size_t i = 0; i < holes; ++i) {
    in.needLine(fmt::format("hole {} of {} of the facet", i + 1, holes));
    in.integer("a hole's number");
    facet.holes.push_back(readPosition(in));
  }
  return facet;
}

Facet readSmeshFacet(TextScanner& in, bool markers, const Numbering& points) {
  Facet facet;
  facet.polygons.push_back(readPolygon(in, points));
  if (markers) facet.marker = static_cast<int>(optionalInteger(in, "a boundary marker"));
  return facet;
}

void readFacets(TextScanner& in, bool smesh, const Numbering& points, Surface& surface) {
  in.needLine("the number of facets");
  const std::size_t count = in.count("facets", 4);
  const bool markers = optionalInteger(in, "the number of boundary markers") > 0;
  if (count == 0) in.fail("there are no facets", "a volume needs a surface around it");
  surface.facets.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    in.needLine(fmt::format("facet {} of {}", i + 1, count));
    surface.facets.push_back(smesh ? readSmeshFacet(in, markers, points) : readPolyFacet(in, markers, points));
  }
}

/// Both parts may be missing at the end of a file.
void readHolesAndRegions(TextScanner& in, Surface& surface) {
  if (!in.nextLine()) return;
  const std::size_t holes = in.count("holes", 8);
  for (std::size_t i = 0; i < holes; ++i) {
    in.needLine(fmt::format("hole {} of {}", i + 1, holes));
    in.integer("a hole's number");
    surface.holes.push_back(readPosition(in));
  }
  if (!in.nextLine()) return;
  const std::size_t regions = in.count("regions", 8);
  for (std::size_t i = 0; i < regions; ++i) {
    in.needLine(fmt::format("region {} of {}", i + 1, regions));
    in.integer("a region's number");
    Region region{readPosition(in)};
    if (in.more()) region.attribute = in.real("the region's attribute");
    if (in.more()) region.maxVolume = in.real("the region's largest volume");
    surface.regions.push_back(region);
  }
}

}  // namespace

Surface readPolySurface(const fs::path& file) {
  Surface surface;
  TextScanner in(file);
  Numbering points = readPoints(in, surface);
  if (points.count == 0) {
    surface = {};
    points = readPointsBeside(file, surface);
  }
  const std::string extension = file.extension().string();
  readFacets(in, extension == ".smesh" || extension == ".SMESH", points, surface);
  readHolesAndRegions(in, surface);
  return surface;
}

}  // namespace havs
