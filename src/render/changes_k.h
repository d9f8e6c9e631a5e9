#pragma once

namespace havs {

struct RenderPlan;

/// A renderer that goes on with another k: what does not depend on k, tables and the mesh above all, is made once.
class ChangesK {
 public:
  virtual ~ChangesK() = default;
  /// The next picture is drawn by `plan`, which is the renderer's own but for k and what follows from it (targets,
  /// tiles, defines). Throws what making a renderer throws; then the renderer is of no use any more.
  virtual void changeK(const RenderPlan& plan) = 0;
};

}  // namespace havs
