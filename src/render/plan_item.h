#pragma once
// What a plan is made of, as `havs plan` and the cost ledger list it.
#include <cstddef>
#include <string>

#include "gl/shader_source.h"

namespace havs {

enum class PlanKind { pass, program, vertexData, target, table, precomputation };
/// "vertex data", for reports.
const char* nameOf(PlanKind kind);

/// One thing that is run, built or kept to draw a scene.
struct PlanItem {
  PlanKind kind = PlanKind::pass;
  std::string name;
  std::string reason;         ///< what of the scene or the machine calls for it
  std::string stage;          ///< of StageTimes: where its time is counted
  std::size_t bytes = 0;      ///< that it keeps, foreseen from the facts of the scene; 0: none, or too few to count
  std::size_t bytesEach = 0;  ///< of one `of`
  std::string of;             ///< what there are many of: "pixel", "point", "face", "entry"; empty: nothing is
};

/// A program of shaders/, or a kernel of the native device.
struct PlannedProgram {
  std::string role;  ///< what its renderer knows it by
  std::string vertex, fragment;
  ShaderOptions options;
};

}  // namespace havs
