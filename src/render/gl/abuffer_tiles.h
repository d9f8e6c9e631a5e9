#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "render/gl/tile.h"

namespace havs {

/// A rectangle of the picture whose fragments are stored at once.
struct FragmentTile {
  Tile area;
  std::size_t fragments;
};

/// Cuts a picture, given the number of fragments of each of its width * height pixels, into tiles that hold at most
/// `mostFragments` each: strips of whole rows, as many as fit, from the first row on, and where a single row holds
/// more, stretches of that row. Tiles without fragments are left out, unless `emptyOnes`. Throws Error{running} where a
/// single pixel holds more.
std::vector<FragmentTile> cutByFragments(std::span<const std::uint32_t> counts, int width, std::size_t mostFragments,
                                         bool emptyOnes = false);

/// Where the list of each pixel of a tile begins, pixel after pixel, and behind them where the last one ends.
std::vector<std::uint32_t> listBegins(std::span<const std::uint32_t> counts, int width, const Tile& tile);

}  // namespace havs
