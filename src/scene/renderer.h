#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "core/stage_times.h"
#include "image/image.h"
#include "scene/ray_layers.h"
#include "scene/view.h"

namespace havs {

/// Whether the fragments of a picture came in an order that its method could mend (docs/02-method.md, The order
/// certificate). Zero misordered fragments: the order of every pixel is exact.
struct Certificate {
  std::size_t fragments = 0;         ///< that were looked at: those of pixels not yet done (early termination)
  std::size_t misordered = 0;        ///< of these
  std::size_t pixels = 0;            ///< that have any misordered
  std::vector<std::uint32_t> count;  ///< of each pixel, row 0 on top
};

/// A picture, and what is known of it.
struct Drawing {
  Image image;
  std::optional<Certificate> certificate;  ///< where the scene asks for it and the method knows it
  std::size_t cycles = 0;                  ///< visibility cycles that the order of the faces has cut
  std::size_t tiles = 1;                   ///< that the picture was drawn in
  std::size_t fragments = 0;               ///< counted by a method that keeps them all, else 0
  std::size_t fragmentBytes = 0;           ///< of memory that these took at once
  std::optional<std::size_t> drawnCells;   ///< where not all show anything (scene/visible_part.h); else all are drawn
};

/// Draws a prepared scene, one for each way of drawing: the rows of visibilityMethods() (render/visibility.h) and the
/// reference (reference/reference_renderer.h). Keeps what pictures share: vertices, tables, programs, targets.
class Renderer {
 public:
  virtual ~Renderer() = default;
  /// The picture as seen by `view`. Times what it does of the stages order, upload, draw, flush, readback. Throws
  /// Error{running} (no memory, ...).
  virtual Drawing draw(const View& view, StageTimes& stages, const Progress& progress = {}) = 0;
  /// What draw() composites besides the volume, of the same view, until it is told otherwise; null: nothing. They must
  /// outlive the drawing. Only of plans with RenderPlan::layers, and of the reference's modes that composite.
  virtual void setLayers(const RayLayers*) {}
};

}  // namespace havs
