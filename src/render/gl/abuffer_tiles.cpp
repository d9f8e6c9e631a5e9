#include "render/gl/abuffer_tiles.h"

#include <numeric>

#include "core/error.h"

namespace havs {
namespace {

void refusePixel(std::size_t fragments, std::size_t mostFragments) {
  failRunning("a pixel has " + std::to_string(fragments) + " fragments, the a-buffer's memory holds " +
                  std::to_string(mostFragments),
              "", "draw with --visibility kbuffer or cells");
}

/// One row in stretches.
void cutRow(std::span<const std::uint32_t> row, int y, std::size_t mostFragments, bool emptyOnes,
            std::vector<FragmentTile>& tiles) {
  int begin = 0;
  std::size_t sum = 0;
  auto close = [&](int end) {
    if (sum > 0 || (emptyOnes && end > begin)) tiles.push_back({{begin, y, end - begin, 1}, sum});
    begin = end;
    sum = 0;
  };
  for (int x = 0; x < static_cast<int>(row.size()); ++x) {
    const std::size_t count = row[static_cast<std::size_t>(x)];
    if (count > mostFragments) refusePixel(count, mostFragments);
    if (sum + count > mostFragments) close(x);
    sum += count;
  }
  close(static_cast<int>(row.size()));
}

}  // namespace

std::vector<FragmentTile> cutByFragments(std::span<const std::uint32_t> counts, int width, std::size_t mostFragments,
                                         bool emptyOnes) {
  const auto stride = static_cast<std::size_t>(width);
  const int height = static_cast<int>(counts.size() / stride);
  std::vector<FragmentTile> tiles;
  int begin = 0;
  std::size_t sum = 0;
  auto close = [&](int end) {
    if (sum > 0 || (emptyOnes && end > begin)) tiles.push_back({{0, begin, width, end - begin}, sum});
    begin = end;
    sum = 0;
  };
  for (int y = 0; y < height; ++y) {
    const auto row = counts.subspan(static_cast<std::size_t>(y) * stride, stride);
    const auto count = std::accumulate(row.begin(), row.end(), std::size_t{0});
    if (count == 0 && sum == 0 && !emptyOnes) begin = y + 1;  // rows without fragments before a strip
    if (sum + count > mostFragments) close(y);
    if (count > mostFragments) {
      cutRow(row, y, mostFragments, emptyOnes, tiles);
      begin = y + 1;
    } else {
      sum += count;
    }
  }
  close(height);
  return tiles;
}

std::vector<std::uint32_t> listBegins(std::span<const std::uint32_t> counts, int width, const Tile& tile) {
  std::vector<std::uint32_t> begins;
  begins.reserve(static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height) + 1);
  std::uint32_t sum = 0;
  for (int y = tile.y; y < tile.y + tile.height; ++y)
    for (int x = tile.x; x < tile.x + tile.width; ++x) {
      begins.push_back(sum);
      sum += counts[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
  begins.push_back(sum);
  return begins;
}

}  // namespace havs
