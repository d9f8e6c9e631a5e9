#pragma once
#include <memory>

#include "core/stage_times.h"
#include "gl/device.h"
#include "image/image.h"
#include "render/prepared_scene.h"
#include "scene/plan.h"
#include "scene/view.h"
#include "sort/face_order.h"

namespace havs {

/// Draws a prepared scene by a plan; one for each way of drawing. Keeps what pictures share (vertices, tables,
/// programs, targets).
class Renderer {
 public:
  virtual ~Renderer() = default;
  /// The picture as seen by `view`, faces in `order`. Stages timed: upload, draw, flush, readback.
  virtual Image draw(const View& view, const FaceOrder& order, StageTimes& stages) = 0;
  /// Pictures larger than a tile are drawn in so many.
  virtual std::size_t tileCount(const View& view) const = 0;
};

/// The k-buffer on OpenGL. `prepared` and the current device must outlive it. Stages timed: table, upload_mesh.
std::unique_ptr<Renderer> makeKBufferRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                                              const Progress& progress = {});

/// What plans need to know of the current OpenGL.
Capabilities capabilitiesOf(const Device& device);

/// Where the faces are sorted from.
ViewPoint viewPointOf(const View& view);

}  // namespace havs
