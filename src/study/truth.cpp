#include "study/truth.h"

#include "reference/edge_mask.h"
#include "render/make_renderer.h"
#include "study/subject.h"
#include "study/timed_draw.h"

namespace havs {

const Truth& Truths::of(const Scene& scene) {
  const std::pair size{scene.width, scene.height};
  if (const auto found = truths_.find(size); found != truths_.end()) return found->second;
  const View view = viewOf(scene, prepared_);
  TimedDrawing timed = drawTimed(*makeReference(scene, prepared_), view);
  ReferenceRecord record{subject_, scene.width, scene.height, "", timed.wallMs, timed.cpuMs};
  if (!folder_.empty()) {
    const std::string name = fileNameOf(subject_ + "-reference-" + std::to_string(std::max(scene.width, scene.height)));
    record.image = "images/" + name + ".png";
    writeImage(timed.drawing.image, folder_ / record.image, {scene.background, 8});
  }
  records_.push_back(std::move(record));
  Truth& truth = truths_[size];
  truth.image = std::move(timed.drawing.image);
  truth.mask = boundaryEdgeMask(prepared_.points, prepared_.faces, view);
  return truth;
}

}  // namespace havs
