#pragma once
#include <vector>

#include "light/mesh_tracer.h"

namespace havs {

/// A light of the local frame.
struct Light {
  enum class Kind {
    directional,  ///< far away; `place` points towards it, of any length but 0
    point         ///< at `place`; its light does not fade with distance
  };
  Kind kind = Kind::directional;
  Vec3 place{0, 0, 1};
  double intensity = 1;

  /// From a point towards the light, of length 1; 0 where the light is at the point.
  Vec3 towards(const Vec3& point) const;
  /// How far the light is from a point; infinite for a directional light.
  double distance(const Vec3& point) const;
};

/// Transmittance from each point towards the light, 0 to 1, of what lies farther than `from` (local units) from the
/// point, and of a point light nearer than the light: exp(-optical depth), 0 where there is an opaque surface. The
/// shadow of lighting (docs/08-effects-data.md) is that from 0 on. 1 at points that are not in the mask. Throws
/// Error{input} for a light without direction and numbers that are not finite. Parallel; the result does not depend on
/// the number of threads.
std::vector<double> shadows(const MeshTracer& tracer, const Light& light, PointMask mask = {}, double from = 0);

}  // namespace havs
