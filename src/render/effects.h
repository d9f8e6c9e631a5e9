#pragma once
// The table of effects: what a scene may have drawn beside the volume, and what may be done with the volume
// (docs/06-add-a-method.md). A mode says what it shows of them.
#include <array>
#include <span>
#include <string>

#include "render/plan.h"
#include "scene/scene.h"

namespace havs {

/// What of the data the default forms of effects are made for.
struct EffectData {
  std::array<double, 2> domain{0, 1};  ///< of the transfer function, in the data's unit
  Vec3 center{0};                      ///< of the mesh, in mesh units
};

/// One row of the table.
struct Effect {
  std::string name;
  std::string description;
  /// Whether the scene asks for it. The check, the light and the plan are called only then.
  bool (*wanted)(const Scene& scene) = nullptr;
  /// Has a scene that does not ask for it do so, in a form that shows it on most data: for studies and tests.
  void (*add)(Scene& scene, const EffectData& data) = nullptr;
  /// Has a scene ask for it no longer, nor for what implies it.
  void (*remove)(Scene& scene) = nullptr;
  /// Numbers that are out of range, and what it cannot be drawn with. Throws Error{input}.
  void (*check)(const Scene& scene) = nullptr;
  /// Its part of the light that fragments carry; null: they carry none for it. A pure function, called in the order of
  /// the rows.
  void (*light)(LightPlan& light, const Scene& scene) = nullptr;
  /// Its part of the plan, defines and resources with their reasons, after the lookup's and before the method's;
  /// RenderPlan::light is there already, of all rows. A pure function. Throws Error like plan().
  void (*plan)(RenderPlan& plan, const Scene& scene, const SceneFacts& facts,
               const Capabilities& capabilities) = nullptr;
};
std::span<const Effect> effects();

/// The light that fragments carry, of all effects that the scene asks for; not lit where none has a part in it.
LightPlan lightPlanOf(const Scene& scene);
/// What fragments carry: light where they are lit, else what the scene's lookup needs.
Payload payloadOf(const Scene& scene);

}  // namespace havs
