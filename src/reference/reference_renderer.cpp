#include "reference/reference_renderer.h"

#include <algorithm>
#include <optional>

#include "reference/lit_ray.h"

namespace havs {
namespace {

/// Every pixel by color(x, y, segments).
template <class Color>
Drawing drawRays(const PreparedScene& prepared, const View& view, const Progress& progress, const Color& color) {
  Drawing drawing;
  Image& image = drawing.image;
  image.width = view.width;
  image.height = view.height;
  image.rgba.resize(4 * static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
  const RayVisitor visit = [&](int x, int y, std::span<const CellSegment> segments) {
    const RayColor found = color(x, y, segments);
    for (std::size_t c = 0; c < 4; ++c) image.pixel(x, y)[c] = static_cast<float>(std::min(found[c], 1.0));
  };
  drawing.tiles = visitRays(prepared, view, visit, {}, progress);
  return drawing;
}

std::span<const RayLayer> layersAt(const RayLayers* layers, int x, int y) {
  return layers == nullptr ? std::span<const RayLayer>() : layers->at(x, y);
}

class ReferenceRenderer final : public Renderer {
 public:
  ReferenceRenderer(const PreparedScene& prepared, RayFunction function) : prepared_(prepared), function_(function) {}

  Drawing draw(const View& view, StageTimes& stages, const Progress& progress) override {
    const ScopedStage timer(stages, "draw");
    return drawRays(prepared_, view, progress, [&](int x, int y, std::span<const CellSegment> segments) {
      return function_({prepared_.curve, prepared_.isosurfaces, layersAt(layers_, x, y)}, segments);
    });
  }

  void setLayers(const RayLayers* layers) override { layers_ = layers; }

 private:
  const PreparedScene& prepared_;
  RayFunction function_;
  const RayLayers* layers_ = nullptr;
};

class LitReferenceRenderer final : public Renderer {
 public:
  LitReferenceRenderer(const PreparedScene& prepared, const LightPlan& light, bool volume)
      : prepared_(prepared), plan_(light), volume_(volume) {}

  Drawing draw(const View& view, StageTimes& stages, const Progress& progress) override {
    if (!light_) light_.emplace(prepared_, plan_, stages);
    const LitRays rays(prepared_, plan_, light_->rowsFor(view, stages), light_->lightsFor(view), view, volume_);
    const ScopedStage timer(stages, "draw");
    return drawRays(prepared_, view, progress, [&](int x, int y, std::span<const CellSegment> segments) {
      return rays.color(x, y, segments, layersAt(layers_, x, y));
    });
  }

  void setLayers(const RayLayers* layers) override { layers_ = layers; }

 private:
  const PreparedScene& prepared_;
  LightPlan plan_;
  bool volume_;
  std::optional<LightData> light_;
  const RayLayers* layers_ = nullptr;
};

}  // namespace

std::unique_ptr<Renderer> makeLitReferenceRenderer(const PreparedScene& prepared, const LightPlan& light, bool volume) {
  return std::make_unique<LitReferenceRenderer>(prepared, light, volume);
}

std::unique_ptr<Renderer> makeReferenceRenderer(const PreparedScene& prepared, RayFunction function) {
  return std::make_unique<ReferenceRenderer>(prepared, function);
}

std::vector<RayColor> referencePixels(const PreparedScene& prepared, const View& view, const ReferenceTiles& tiles) {
  std::vector<RayColor> pixels(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
  const RayVisitor visit = [&](int x, int y, std::span<const CellSegment> segments) {
    pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width) + static_cast<std::size_t>(x)] =
        rayColor({prepared.curve, prepared.isosurfaces}, segments);
  };
  visitRays(prepared, view, visit, tiles);
  return pixels;
}

}  // namespace havs
