#pragma once
#include <array>
#include <memory>
#include <vector>

#include "core/stage_times.h"
#include "light/light_plan.h"
#include "scene/prepared_scene.h"
#include "scene/view.h"

namespace havs {

/// A light as one view sees it, in the local frame.
struct ViewLight {
  bool atPlace = false;  ///< `place` is where it is; else the direction towards it, of length 1
  Vec3 place{0};
  double intensity = 1;
};

/// The numbers of points that light is made of (LightPlan), made once for a scene: gradients, occlusion, shadows, and
/// what scatters; and what of it changes with the view.
class LightData {
 public:
  /// `drawn`: the scene, or the part of it that is drawn; light goes through the whole. Stages timed: gradients,
  /// tracer, occlusion, scattering_table. Directions of lights are longer than 0.
  LightData(const PreparedScene& drawn, const LightPlan& plan, StageTimes& stages);
  ~LightData();
  LightData(LightData&&) noexcept;

  /// One row of LightPlan::rowLength numbers for each point of the drawn scene, brought up to date for the view. Stages
  /// timed: shadows, scattering.
  const std::vector<float>& rowsFor(const View& view, StageTimes& stages);
  /// Grows whenever rows change; 1 at first.
  std::size_t version() const;
  /// The plan's lights.
  std::vector<ViewLight> lightsFor(const View& view) const;

 private:
  struct Whole;
  std::unique_ptr<Whole> whole_;
};

}  // namespace havs
