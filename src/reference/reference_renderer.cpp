#include "reference/reference_renderer.h"

namespace havs {
namespace {

class ReferenceRenderer final : public Renderer {
 public:
  ReferenceRenderer(const PreparedScene& prepared, RayFunction function) : prepared_(prepared), function_(function) {}

  Drawing draw(const View& view, StageTimes& stages, const Progress& progress) override {
    const ScopedStage timer(stages, "draw");
    Drawing drawing;
    Image& image = drawing.image;
    image.width = view.width;
    image.height = view.height;
    image.rgba.resize(4 * static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
    const RayVisitor visit = [&](int x, int y, std::span<const CellSegment> segments) {
      const RayColor color = function_({prepared_.curve, prepared_.isosurfaces}, segments);
      for (std::size_t c = 0; c < 4; ++c) image.pixel(x, y)[c] = static_cast<float>(color[c]);
    };
    drawing.tiles = visitRays(prepared_, view, visit, {}, progress);
    return drawing;
  }

 private:
  const PreparedScene& prepared_;
  RayFunction function_;
};

}  // namespace

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
