#pragma once
// The table of modes: what a pixel shows of the scalar along its ray (docs/03-scene.md, Modes).
#include <array>
#include <span>
#include <string>

#include "reference/ray_sums.h"
#include "render/lookups.h"
#include "render/visibility.h"
#include "transfer/extinction_curve.h"

namespace havs {

/// How what the ray's segments, or the faces that it meets, give comes together in a pixel. All but `composite` come to
/// the same in any order.
enum class Gathering {
  composite,  ///< front to back, by a visibility method
  sum,        ///< of the segments, each measured by Mode::measure
  greatest,   ///< scalar at a face: inside a cell it is linear, so no other is greater
  least
};

/// One row of the table (`--mode`).
struct Mode {
  std::string name;
  std::string description;
  Gathering gathering = Gathering::composite;
  /// What a segment adds (Gathering::sum): four numbers that its shader names. Gathering::composite: what stands for
  /// the scene's lookup, where it has a shader.
  Lookup measure;
  std::string measureOfFewKnots;  ///< another shader for it, where cells hold few knots (fewKnots in render/plan.h)
  Lookup measureOfFewPieces;      ///< before that, of SceneFacts::fewPieces; its number is that of the pieces
  /// What a pixel holds before anything has been gathered.
  std::array<float, 4> start{0, 0, 0, 0};
  /// From what a pixel has gathered to its premultiplied colour, in place.
  void (*finish)(const ExtinctionCurve& curve, float* pixel) = nullptr;
  /// The same of a whole ray in double, from its segments: the ground truth.
  RayFunction reference = nullptr;
  /// Cells over whose scalars the transfer function is clear matter, too.
  bool seesClearCells = false;
  bool seesOpaqueSurfaces = true;
  bool seesVolume = true;  ///< else isosurfaces only
  DrawingWay gl, native;   ///< of all but `composite`, which a visibility method draws
};
std::span<const Mode> modes();
/// Whether a mode composites by the scene's lookup.
inline bool usesLookup(const Mode& mode) {
  return mode.gathering == Gathering::composite && mode.measure.shader.empty();
}
/// Throws Error{input}, naming the nearest.
const Mode& mode(const std::string& name);

}  // namespace havs
