#pragma once
#include <array>
#include <span>
#include <vector>

#include "render/native/face_bins.h"
#include "render/native/kernels.h"
#include "render/native/segment_shader.h"
#include "scene/renderer.h"
#include "scene/view.h"

namespace havs {

/// How the tiles of a picture are drawn.
struct TileSetting {
  TileKernel kernel = nullptr;   ///< of the plan's k
  TileKernel ordered = nullptr;  ///< tried first; null: none
  int k = 0;
  int attributes = 1;  ///< numbers that a fragment carries
  bool certificate = false;
  bool compositeLate = false;
  bool orderIsBelieved = false;  ///< SortMethod::isBelieved
  float terminalOpacity = 2;
  const SegmentShader* shader = nullptr;
  const RayLayers* layers = nullptr;       ///< null: none
  const TileLight* light = nullptr;        ///< Payload::lit
  bool adds = false;                       ///< segments add up in a pixel, instead of being composited
  std::array<float, 4> start{0, 0, 0, 0};  ///< what a pixel holds before anything is drawn
};

/// Draws tiles, one at a time: a thread's own memory.
class TileWorker {
 public:
  TileWorker(const RasterMesh& mesh, const View& view, const TileGrid& grid, const TileSetting& setting);
  /// Into the picture and, where it has one, its certificate's counts.
  void draw(std::size_t tile, std::span<const std::uint32_t> faces, Drawing& drawing);
  std::uint64_t fragments() const { return fragments_; }               ///< of all tiles so far
  std::uint64_t lateFragments() const { return tile_.lateFragments; }  ///< the same

 private:
  void place(std::size_t tile);
  void startLayers();
  void restartLayers(std::size_t pixel);
  void takeRestOfLayers();
  void run(TileKernel kernel, std::span<const std::uint32_t> faces);
  void redraw(std::span<const std::uint32_t> faces);
  void write(Drawing& drawing) const;

  const RasterMesh& mesh_;
  const View& view_;
  TileGrid grid_;
  TileSetting setting_;
  TileDraw tile_{};
  int width_ = 0, height_ = 0;  ///< of the tile's pixels inside the picture
  std::vector<std::uint16_t> active_, flagged_;
  std::vector<float> state_, rayScale_, rgba_;
  std::vector<std::uint32_t> late_;
  std::vector<std::uint32_t> nextLayer_, endLayer_;
  std::unique_ptr<SegmentQueue> queue_;
  std::uint64_t fragments_ = 0;
};

}  // namespace havs
