#include "render/overlay_renderer.h"

#include <optional>

#include "overlay/boundary_layers.h"
#include "overlay/outline.h"
#include "render/changes_k.h"

namespace havs {
namespace {

class OverlayRenderer final : public Renderer, public ChangesK {
 public:
  OverlayRenderer(const PreparedScene& prepared, const Overlays& overlays, std::unique_ptr<Renderer> renderer)
      : halfSize_(prepared.frame.halfSize / prepared.frame.radius),
        overlays_(overlays),
        prepared_(prepared),
        renderer_(std::move(renderer)) {}

  Drawing draw(const View& view, StageTimes& stages, const Progress& progress) override {
    std::optional<RayLayers> layers;
    if (overlays_.layers()) {
      const ScopedStage timer(stages, "layers");
      if (!boundary_) boundary_.emplace(prepared_, overlays_);
      layers = boundary_->of(view);
    }
    renderer_->setLayers(layers ? &*layers : nullptr);
    Drawing drawing = renderer_->draw(view, stages, progress);
    renderer_->setLayers(nullptr);
    if (overlays_.outline) {
      const ScopedStage timer(stages, "outline");
      addOutline(drawing.image, *overlays_.outline, halfSize_, view);
    }
    return drawing;
  }

  void changeK(const RenderPlan& plan) override { dynamic_cast<ChangesK&>(*renderer_).changeK(plan); }

 private:
  Vec3 halfSize_;
  Overlays overlays_;
  const PreparedScene& prepared_;
  std::unique_ptr<Renderer> renderer_;
  std::optional<BoundaryLayers> boundary_;
};

}  // namespace

std::unique_ptr<Renderer> rendererWithOverlays(const PreparedScene& prepared, const Overlays& overlays,
                                               std::unique_ptr<Renderer> renderer) {
  return std::make_unique<OverlayRenderer>(prepared, overlays, std::move(renderer));
}

}  // namespace havs
