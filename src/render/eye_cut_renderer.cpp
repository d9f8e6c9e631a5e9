#include "render/eye_cut_renderer.h"

#include <optional>

#include "render/changes_k.h"
#include "scene/eye_cut.h"

namespace havs {
namespace {

/// What a cut follows from.
struct Seen {
  bool orthographic;
  int width, height;
  Vec3 eye, center, forward, right;
  double halfWidth, halfHeight;
  bool operator==(const Seen&) const = default;
};

class AnyEyeRenderer final : public Renderer, public ChangesK {
 public:
  AnyEyeRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages, const Progress& progress,
                 RendererMaker make)
      : prepared_(prepared), plan_(plan), make_(std::move(make)), how_(plan.native ? kEyeCutInDouble : kEyeCutInFloat) {
    renderer_ = make_(prepared_, plan_, stages, progress);
  }

  Drawing draw(const View& view, StageTimes& stages, const Progress& progress) override {
    if (cutFor(view, stages) || !renderer_) renderer_ = make_(drawn(), plan_, stages, progress);
    std::optional<RayLayers> moved;
    if (layers_ != nullptr && part_) moved = seenFrom(*layers_, view, part_->origin);
    renderer_->setLayers(moved ? &*moved : layers_);
    Drawing drawing = renderer_->draw(part_ ? viewOfCut(*part_, view) : view, stages, progress);
    if (part_ && !drawing.drawnCells) drawing.drawnCells = part_->mesh.tetrahedra.size();
    return drawing;
  }

  void setLayers(const RayLayers* layers) override { layers_ = layers; }

  void changeK(const RenderPlan& plan) override {
    plan_ = plan;
    if (auto* same = dynamic_cast<ChangesK*>(renderer_.get())) return same->changeK(plan);
    renderer_.reset();
  }

 private:
  const PreparedScene& drawn() const { return part_ ? *part_ : prepared_; }

  /// Cuts the mesh as the view needs it. Whether that is another mesh than before.
  bool cutFor(const View& view, StageTimes& stages) {
    std::optional<ScopedStage> timer;
    if (eyeIsNear(view, how_) || showsTooFine(view, how_)) timer.emplace(stages, "eye_cut");
    std::optional<Seen> cut;
    if (needsEyeCut(prepared_, view, how_))
      cut = Seen{view.orthographic, view.width, view.height,    view.eye,       view.center,
                 view.forward,      view.right, view.halfWidth, view.halfHeight};
    if (cut == cut_) return false;
    renderer_.reset();  // before what it draws, and its memory before the next one's
    part_.reset();
    cut_.reset();
    if (cut) part_ = std::make_unique<PreparedScene>(cutBeforeEye(prepared_, view, how_));
    cut_ = cut;
    return true;
  }

  const PreparedScene& prepared_;
  RenderPlan plan_;
  RendererMaker make_;
  EyeCut how_;
  std::unique_ptr<PreparedScene> part_;  // drawn instead of all, where there is one
  std::unique_ptr<Renderer> renderer_;
  std::optional<Seen> cut_;
  const RayLayers* layers_ = nullptr;
};

}  // namespace

std::unique_ptr<Renderer> rendererForAnyEye(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                                            const Progress& progress, RendererMaker make) {
  return std::make_unique<AnyEyeRenderer>(prepared, plan, stages, progress, std::move(make));
}

}  // namespace havs
