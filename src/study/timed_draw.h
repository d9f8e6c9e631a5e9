#pragma once
#include "scene/renderer.h"

namespace havs {

/// A drawing and what its frame took: all that draw() does but reading the picture back.
struct TimedDrawing {
  Drawing drawing;
  double wallMs = 0;  ///< sum of the stages
  double cpuMs = 0;   ///< processor time of all threads of this process meanwhile
  StageTimes stages;  ///< of the drawing, reading back too
};

/// Draws once and measures it. Nothing else may run in this process meanwhile. Throws what the renderer throws.
TimedDrawing drawTimed(Renderer& renderer, const View& view);

}  // namespace havs
