#include "study/timed_draw.h"

#include <algorithm>

#include "core/memory.h"

namespace havs {

TimedDrawing drawTimed(Renderer& renderer, const View& view) {
  TimedDrawing result;
  StageTimes& stages = result.stages;
  const double before = cpuSeconds();
  result.drawing = renderer.draw(view, stages);
  const double cpu = 1e3 * (cpuSeconds() - before);
  const double readback = stages.total("readback");
  for (const auto& [stage, median] : stages.medians())
    if (stage != "readback") result.wallMs += stages.total(stage);
  result.cpuMs = std::max(0.0, cpu - readback);  // one thread copies the picture
  return result;
}

}  // namespace havs
