#pragma once
#include "fuzz/fuzz.h"
#include "mesh/tetgen_surface.h"

namespace havs::fuzz {

/// What runTetgen hands to TetGen as it is.
inline void requireSound(const Surface& surface) {
  for (const Facet& facet : surface.facets)
    for (const std::vector<int>& polygon : facet.polygons)
      for (const int corner : polygon)
        require(corner >= 0 && static_cast<std::size_t>(corner) < surface.points.size(), "a facet's points exist");
  for (const Field& field : surface.pointFields)
    require(field.values.size() == surface.points.size(), "each point has its attributes");
}

/// A target of one reader.
inline int readSurface(const std::string& name, std::string_view text, Surface (*read)(const std::filesystem::path&)) {
  const auto file = asFile(name, text);
  readOrRefuse([&] { requireSound(read(file)); });
  return 0;
}

}  // namespace havs::fuzz
