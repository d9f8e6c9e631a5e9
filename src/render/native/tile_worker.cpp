#include "render/native/tile_worker.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/arithmetic.h"

namespace havs {
namespace {

/// Number of a tile's pixel in the order of stamps.
std::size_t pixelAt(const TileDraw& tile, int x, int y) {
  const int stamp = y / kStampSide * tile.stampsAcross + x / kStampSide;
  return static_cast<std::size_t>(stamp * kStampPixels + y % kStampSide * kStampSide + x % kStampSide);
}

void endPixel(TileDraw& tile, std::size_t pixel) {
  std::uint16_t& active = tile.active[pixel / kStampPixels];
  const unsigned bit = 1u << pixel % kStampPixels;
  if ((active & bit) == 0) return;
  active = static_cast<std::uint16_t>(active & ~bit);
  --tile.activePixels;
}

/// compositeUnder of shaders/core/compositing.glsl, the four channels at once.
using Four [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = float;

Four compositeUnder(Four front, Four back) { return front + (1.0f - front[3]) * back; }

void addQueue(TileDraw& tile) {
  SegmentQueue& queue = *tile.queue;
  if (queue.count == 0) return;
  static_cast<const SegmentShader*>(tile.shader)->shade(queue);
  Four* const rgba = reinterpret_cast<Four*>(tile.rgba);
  const Four* const added = reinterpret_cast<const Four*>(queue.rgba.data());
  for (std::size_t i = 0; i < queue.count; ++i) rgba[queue.pixel[i]] += added[i];
  queue.count = 0;
}

void flushQueue(TileDraw& tile) {
  SegmentQueue& queue = *tile.queue;
  if (queue.count == 0) return;
  static_cast<const SegmentShader*>(tile.shader)->shade(queue);
  Four* const rgba = reinterpret_cast<Four*>(tile.rgba);
  const Four* const color = reinterpret_cast<const Four*>(queue.rgba.data());
  if (tile.terminalOpacity > 1) {
    for (std::size_t i = 0; i < queue.count; ++i) {
      Four& sum = rgba[queue.pixel[i]];
      sum = compositeUnder(sum, color[i]);
    }
  } else {
    for (std::size_t i = 0; i < queue.count; ++i) {
      Four& sum = rgba[queue.pixel[i]];
      if (sum[3] >= tile.terminalOpacity) continue;
      sum = compositeUnder(sum, color[i]);
      if (sum[3] >= tile.terminalOpacity) endPixel(tile, static_cast<std::size_t>(queue.pixel[i]));
    }
  }
  queue.count = 0;
}

/// The layers of a pixel nearer than `distance`, of those left.
void takeLayers(TileDraw& tile, std::size_t pixel, double distance) {
  Four& sum = reinterpret_cast<Four*>(tile.rgba)[pixel];
  std::uint32_t& next = tile.nextLayer[pixel];
  for (; next < tile.endLayer[pixel] && tile.layers[next].distance < distance; ++next) {
    if (sum[3] >= tile.terminalOpacity) return;
    sum = compositeUnder(sum, *reinterpret_cast<const Four*>(tile.layers[next].rgba.data()));
  }
}

/// flushQueue with layers between the segments.
void flushAmongLayers(TileDraw& tile) {
  SegmentQueue& queue = *tile.queue;
  if (queue.count == 0) return;
  static_cast<const SegmentShader*>(tile.shader)->shade(queue);
  Four* const rgba = reinterpret_cast<Four*>(tile.rgba);
  const Four* const color = reinterpret_cast<const Four*>(queue.rgba.data());
  for (std::size_t i = 0; i < queue.count; ++i) {
    const auto pixel = static_cast<std::size_t>(queue.pixel[i]);
    Four& sum = rgba[pixel];
    if (sum[3] >= tile.terminalOpacity) continue;
    takeLayers(tile, pixel, static_cast<double>(queue.middle[i]));
    if (sum[3] < tile.terminalOpacity) sum = compositeUnder(sum, color[i]);
    if (sum[3] >= tile.terminalOpacity) endPixel(tile, pixel);
  }
  queue.count = 0;
}

}  // namespace

TileWorker::TileWorker(const RasterMesh& mesh, const View& view, const TileGrid& grid, const TileSetting& setting)
    : mesh_(mesh), view_(view), grid_(grid), setting_(setting), queue_(std::make_unique<SegmentQueue>()) {
  queue_->scalarFront.fill(0);  // kernels read whole lanes
  queue_->scalarBack.fill(0);
  queue_->length.fill(0);
  queue_->middle.fill(0);
  for (int i = 0; i < 4; ++i) {
    queue_->front[static_cast<std::size_t>(i)].fill(0);
    queue_->back[static_cast<std::size_t>(i)].fill(0);
  }
  const auto stamps =
      static_cast<std::size_t>(grid.side / kStampSide) * static_cast<std::size_t>(grid.side / kStampSide);
  const std::size_t pixels = stamps * kStampPixels;
  active_.resize(stamps);
  flagged_.resize(stamps);
  state_.resize(pixels * static_cast<std::size_t>(2 + setting.k * (2 + setting.attributes)));
  rayScale_.resize(pixels);
  rgba_.resize(4 * pixels);
  if (setting.certificate) late_.resize(pixels);
  if (setting.layers != nullptr) {
    nextLayer_.resize(pixels);
    endLayer_.resize(pixels);
  }

  tile_.mesh = mesh;
  tile_.stampsAcross = tile_.stampsDown = grid.side / kStampSide;
  tile_.active = active_.data();
  tile_.flagged = flagged_.data();
  tile_.state = state_.data();
  tile_.rayScale = rayScale_.data();
  tile_.rgba = rgba_.data();
  tile_.late = setting.certificate ? late_.data() : nullptr;
  tile_.compositeLate = setting.compositeLate;
  tile_.sameDistance = setting.orderIsBelieved ? Arithmetic<FloatLane>::kLateTolerance : 0;
  tile_.flushAlways = setting.certificate && setting.terminalOpacity <= 1;
  tile_.queue = queue_.get();
  tile_.flush = setting.adds ? addQueue : setting.layers != nullptr ? flushAmongLayers : flushQueue;
  if (setting.layers != nullptr) tile_.layers = setting.layers->layers.data();
  tile_.nextLayer = nextLayer_.data();
  tile_.endLayer = endLayer_.data();
  tile_.shader = setting.shader;
  tile_.light = setting.light;
  tile_.terminalOpacity = setting.terminalOpacity;
}

void TileWorker::place(std::size_t tile) {
  tile_.left = static_cast<int>(tile % static_cast<std::size_t>(grid_.across)) * grid_.side;
  tile_.top = static_cast<int>(tile / static_cast<std::size_t>(grid_.across)) * grid_.side;
  width_ = std::min(grid_.side, mesh_.width - tile_.left);
  height_ = std::min(grid_.side, mesh_.height - tile_.top);
  std::fill(active_.begin(), active_.end(), std::uint16_t{0});
  std::fill(flagged_.begin(), flagged_.end(), std::uint16_t{0});
  for (std::size_t i = 0; i < rgba_.size(); ++i) rgba_[i] = setting_.start[i % 4];
  std::fill(late_.begin(), late_.end(), 0u);
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      const std::size_t pixel = pixelAt(tile_, x, y);
      rayScale_[pixel] = static_cast<float>(view_.rayScale(tile_.left + x + 0.5, tile_.top + y + 0.5));
      active_[pixel / kStampPixels] =
          static_cast<std::uint16_t>(active_[pixel / kStampPixels] | 1u << pixel % kStampPixels);
    }
}

/// None of them is composited.
void TileWorker::startLayers() {
  std::fill(nextLayer_.begin(), nextLayer_.end(), 0u);  // beside the picture there are none
  std::fill(endLayer_.begin(), endLayer_.end(), 0u);
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) restartLayers(pixelAt(tile_, x, y));
}

void TileWorker::restartLayers(std::size_t pixel) {
  const int stamp = static_cast<int>(pixel) / kStampPixels, lane = static_cast<int>(pixel) % kStampPixels;
  const int x = stamp % tile_.stampsAcross * kStampSide + lane % kStampSide;
  const int y = stamp / tile_.stampsAcross * kStampSide + lane / kStampSide;
  const RayLayers& layers = *setting_.layers;
  const std::size_t from = layers.pixel(tile_.left + x, tile_.top + y);
  nextLayer_[pixel] = layers.begin[from];
  endLayer_[pixel] = layers.begin[from + 1];
}

void TileWorker::takeRestOfLayers() {
  for (std::size_t pixel = 0; pixel < nextLayer_.size(); ++pixel)
    takeLayers(tile_, pixel, std::numeric_limits<double>::infinity());
}

void TileWorker::run(TileKernel kernel, std::span<const std::uint32_t> faces) {
  tile_.faces = faces.data();
  tile_.faceCount = faces.size();
  tile_.activePixels = 0;
  for (const std::uint16_t bits : active_) tile_.activePixels += static_cast<std::size_t>(std::popcount(bits));
  kernel(tile_);
}

void TileWorker::draw(std::size_t tile, std::span<const std::uint32_t> faces, Drawing& drawing) {
  if (faces.empty() && setting_.layers == nullptr) return;
  place(tile);
  if (setting_.layers != nullptr) startLayers();
  tile_.fragments = 0;
  run(setting_.ordered != nullptr ? setting_.ordered : setting_.kernel, faces);
  fragments_ += tile_.fragments;
  if (setting_.ordered != nullptr) redraw(faces);
  if (setting_.layers != nullptr) takeRestOfLayers();
  write(drawing);
}

/// The flagged pixels anew with the full k.
void TileWorker::redraw(std::span<const std::uint32_t> faces) {
  std::size_t pixels = 0;
  for (std::size_t stamp = 0; stamp < flagged_.size(); ++stamp) {
    active_[stamp] = flagged_[stamp];
    pixels += static_cast<std::size_t>(std::popcount(flagged_[stamp]));
    for (unsigned left = flagged_[stamp]; left != 0; left &= left - 1) {
      const std::size_t pixel = stamp * kStampPixels + static_cast<std::size_t>(std::countr_zero(left));
      std::fill_n(&rgba_[4 * pixel], 4, 0.0f);
      if (setting_.layers != nullptr) restartLayers(pixel);
    }
  }
  if (pixels == 0) return;
  run(setting_.kernel, faces);
}

void TileWorker::write(Drawing& drawing) const {
  for (int y = 0; y < height_; ++y) {
    const auto first = static_cast<std::size_t>(tile_.top + y) * static_cast<std::size_t>(mesh_.width) +
                       static_cast<std::size_t>(tile_.left);
    for (int x = 0; x < width_; ++x) {
      const std::size_t from = pixelAt(tile_, x, y), to = first + static_cast<std::size_t>(x);
      std::copy_n(&rgba_[4 * from], 4, &drawing.image.rgba[4 * to]);
      if (drawing.certificate) drawing.certificate->count[to] = late_[from];
    }
  }
}

}  // namespace havs
