#include "scene/visible_part_renderer.h"

#include "scene/visible_part.h"

namespace havs {
namespace {

std::size_t pixelsOf(const View& view) {
  return static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
}

/// Nothing shows: no order, no table, no context is asked for anything.
class NothingRenderer final : public Renderer {
 public:
  explicit NothingRenderer(bool certificate) : certificate_(certificate) {}

  Drawing draw(const View& view, StageTimes&, const Progress&) override {
    Drawing drawing;
    drawing.image = {view.width, view.height, std::vector<float>(4 * pixelsOf(view))};
    if (layers_ != nullptr) compositeLayers(drawing.image);
    if (certificate_) drawing.certificate.emplace().count.assign(pixelsOf(view), 0);
    drawing.drawnCells = 0;
    return drawing;
  }

  void setLayers(const RayLayers* layers) override { layers_ = layers; }

 private:
  void compositeLayers(Image& image) const {
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        float* const sum = image.pixel(x, y);
        LayersOfRay(layers_->at(x, y)).rest([&](const std::array<float, 4>& rgba) {
          const float through = 1 - sum[3];
          for (std::size_t c = 0; c < 4; ++c) sum[c] += through * rgba[c];
        });
      }
  }

  bool certificate_;
  const RayLayers* layers_ = nullptr;
};

class PartRenderer final : public Renderer {
 public:
  PartRenderer(std::unique_ptr<PreparedScene> part, std::unique_ptr<Renderer> renderer)
      : part_(std::move(part)), renderer_(std::move(renderer)) {}

  Drawing draw(const View& view, StageTimes& stages, const Progress& progress) override {
    Drawing drawing = renderer_->draw(view, stages, progress);
    drawing.drawnCells = part_->mesh.tetrahedra.size();
    return drawing;
  }

  void setLayers(const RayLayers* layers) override { renderer_->setLayers(layers); }

 private:
  std::unique_ptr<PreparedScene> part_;  // the renderer draws it
  std::unique_ptr<Renderer> renderer_;
};

}  // namespace

std::unique_ptr<Renderer> rendererOfNothing(bool certificate) { return std::make_unique<NothingRenderer>(certificate); }

std::unique_ptr<Renderer> rendererOfVisiblePart(
    const PreparedScene& prepared, const WhatShows& what, bool certificate, StageTimes& stages,
    const std::function<std::unique_ptr<Renderer>(const PreparedScene&)>& make) {
  std::unique_ptr<PreparedScene> part;
  {
    const ScopedStage timer(stages, "visible");
    if (auto visible = visiblePart(prepared, what)) part = std::make_unique<PreparedScene>(std::move(*visible));
  }
  if (!part) return make(prepared);
  if (part->mesh.tetrahedra.empty()) return rendererOfNothing(certificate);
  auto renderer = make(*part);
  return std::make_unique<PartRenderer>(std::move(part), std::move(renderer));
}

}  // namespace havs
