#pragma once
#include <memory>

#include "core/progress.h"
#include "render/native/instruction_sets.h"
#include "render/native/segment_queue.h"
#include "render/plan.h"
#include "scene/prepared_scene.h"

namespace havs {

/// The lookup of a plan on SIMD lanes: what segment_color.glsl does for a segment, cut at opaque surfaces where there
/// are any. Keeps the tables.
class SegmentShader {
 public:
  SegmentShader(const PreparedScene& prepared, const RenderPlan& plan, const InstructionSet& instructions,
                const Progress& progress = {});
  SegmentShader(SegmentShader&& other) noexcept;
  ~SegmentShader();

  /// Writes `rgba` of the queue's first `count` segments. From any number of threads, each with a queue of its own.
  void shade(SegmentQueue& queue) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace havs
