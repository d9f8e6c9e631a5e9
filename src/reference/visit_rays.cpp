// The picture is halved until its parts are small; each keeps a list of the cells whose boxes it meets. A part is then
// cut into tiles that threads take one by one: cells are projected again in each tile that they meet, and nothing is
// kept of a tile but its segments. So memory is that of the projected points, a box and a few numbers a cell, and one
// tile a thread.
#include <algorithm>
#include <atomic>
#include <mutex>

#include "core/parallel.h"
#include "reference/reference_renderer.h"

namespace havs {
namespace {

constexpr int kTilesOfAPart = 16;  // each way

using Boxes = std::vector<PixelBox>;
using CellList = std::vector<Index>;

struct Halves {
  PixelBox first, second;
};
/// Cut across the longer side. Side by side, or one above the other; of more than one pixel.
Halves halves(const PixelBox& box) {
  Halves h{box, box};
  if (box.right - box.left >= box.bottom - box.top) {
    h.first.right = box.left + (box.right - box.left - 1) / 2;
    h.second.left = h.first.right + 1;
  } else {
    h.first.bottom = box.top + (box.bottom - box.top - 1) / 2;
    h.second.top = h.first.bottom + 1;
  }
  return h;
}

/// Tells how much of the picture is done, one thread at a time.
class PixelProgress {
 public:
  PixelProgress(const Progress& progress, double pixels) : progress_(progress), pixels_(pixels) {}
  void done(double pixels) {
    if (!progress_) return;
    const std::lock_guard lock(mutex_);
    done_ += pixels;
    progress_("drawing", done_ / pixels_);
  }

 private:
  const Progress& progress_;
  double pixels_;
  double done_ = 0;
  std::mutex mutex_;
};

class RayCaster {
 public:
  RayCaster(const PreparedScene& prepared, const View& view, const RayVisitor& visit, const ReferenceTiles& tiles,
            const Progress& progress)
      : view_(view), visit_(visit), tiles_(tiles), progress_(progress, static_cast<double>(view.width) * view.height) {
    mesh_.cells = prepared.mesh.tetrahedra;
    mesh_.points = screenPoints(prepared.points, view);
    mesh_.scalars = prepared.scalars;
    mesh_.cellData = prepared.field.centering == Centering::cell;
    mesh_.eyeDepth = view.depth(view.eye);
    mesh_.width = view.width;
    mesh_.height = view.height;
  }

  std::size_t run() {
    boxes_.resize(mesh_.cells.size());
    parallelFor(0, boxes_.size(), 4096, [&](std::size_t c) {
      std::array<ScreenPoint, 4> corners;
      for (std::size_t i = 0; i < 4; ++i) corners[i] = mesh_.points[mesh_.cells[c][i]];
      boxes_[c] = boxOf(corners, view_.width, view_.height);
    });
    CellList all(boxes_.size());
    for (std::size_t c = 0; c < all.size(); ++c) all[c] = static_cast<Index>(c);
    const PixelBox picture{0, 0, view_.width - 1, view_.height - 1};
    drawPart(picture, cellsIn(picture, all));
    return tileCount_;
  }

 private:
  CellList cellsIn(const PixelBox& part, const CellList& of) const {
    CellList cells;
    std::copy_if(of.begin(), of.end(), std::back_inserter(cells),
                 [&](Index c) { return !intersection(boxes_[c], part).empty(); });
    return cells;
  }

  void drawPart(const PixelBox& part, CellList cells) {
    const int side = kTilesOfAPart * tiles_.side;
    if (part.right - part.left < side && part.bottom - part.top < side) return drawTiles(part, cells);
    const auto [first, second] = halves(part);
    CellList inFirst = cellsIn(first, cells), inSecond = cellsIn(second, cells);
    cells = {};
    drawPart(first, std::move(inFirst));
    drawPart(second, std::move(inSecond));
  }

  void drawTiles(const PixelBox& part, const CellList& cells) {
    const int side = tiles_.side;
    const int across = (part.right - part.left) / side + 1, down = (part.bottom - part.top) / side + 1;
    const auto count = static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
    std::vector<CellList> cellsOf(count);
    for (const Index c : cells) {
      const PixelBox box = intersection(boxes_[c], part);
      for (int y = (box.top - part.top) / side; y <= (box.bottom - part.top) / side; ++y)
        for (int x = (box.left - part.left) / side; x <= (box.right - part.left) / side; ++x)
          cellsOf[static_cast<std::size_t>(y * across + x)].push_back(c);
    }
    parallelBlocks(0, count, 1, [&](std::size_t firstTile, std::size_t lastTile) {
      SegmentCollector collector(mesh_);
      for (std::size_t tile = firstTile; tile < lastTile; ++tile) {
        const int left = part.left + static_cast<int>(tile) % across * side;
        const int top = part.top + static_cast<int>(tile) / across * side;
        const PixelBox box{left, top, std::min(left + side - 1, part.right), std::min(top + side - 1, part.bottom)};
        drawTile(collector, box, cellsOf[tile]);
        cellsOf[tile] = {};
      }
    });
  }

  /// Halves what may hold too many segments, down to one pixel.
  void drawTile(SegmentCollector& collector, const PixelBox& tile, const CellList& cells) {
    double most = 0;
    for (const Index c : cells) most += intersection(boxes_[c], tile).area();
    if (most > tiles_.mostSegments && tile.area() > 1) {
      const auto [first, second] = halves(tile);
      drawTile(collector, first, cellsIn(first, cells));
      drawTile(collector, second, cellsIn(second, cells));
      return;
    }
    collector.reset(tile);
    for (const Index c : cells) collector.add(c, boxes_[c]);
    for (int y = tile.top; y <= tile.bottom; ++y)
      for (int x = tile.left; x <= tile.right; ++x) visit_(x, y, collector.at(x, y, view_.rayScale(x + 0.5, y + 0.5)));
    ++tileCount_;
    progress_.done(tile.area());
  }

  const View& view_;
  const RayVisitor& visit_;
  ReferenceTiles tiles_;
  PixelProgress progress_;
  ScreenMesh mesh_;
  Boxes boxes_;
  std::atomic<std::size_t> tileCount_{0};
};

}  // namespace

std::size_t visitRays(const PreparedScene& prepared, const View& view, const RayVisitor& visit,
                      const ReferenceTiles& tiles, const Progress& progress) {
  return RayCaster(prepared, view, visit, tiles, progress).run();
}

}  // namespace havs
