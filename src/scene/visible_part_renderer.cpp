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
    if (certificate_) drawing.certificate.emplace().count.assign(pixelsOf(view), 0);
    drawing.drawnCells = 0;
    return drawing;
  }

 private:
  bool certificate_;
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
