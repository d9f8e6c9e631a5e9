#pragma once
#include <span>
#include <vector>

#include "light/ambient_occlusion.h"
#include "light/scattering_table.h"
#include "light/shadows.h"

namespace havs {

/// What ambient scattering needs of each point, whatever the view.
struct ScatteringData {
  std::vector<double> opticalRadius;               ///< BallValues::opticalRadius
  std::vector<std::vector<double>> transmittance;  ///< of each light, one a point: shadows from the ball's radius on
};

/// `opticalRadius`: of ballValues with the same radius (which may be wanted for occlusion, too). Points that are not in
/// the mask have transmittance 1. Throws Error{input} as shadows.
ScatteringData scatteringData(const MeshTracer& tracer, std::vector<double> opticalRadius, double radius,
                              std::span<const Light> lights, PointMask mask = {});

/// Where the view rays come from.
struct ViewRays {
  bool parallel = false;
  Vec3 place{0};  ///< the eye; of parallel rays their direction, away from the eye, of length 1
  /// Direction of the ray through a point, of length 1; 0 at the eye itself.
  Vec3 at(const Vec3& point) const;
};

/// The light that each point sends towards the eye for the sake of scattering around it (docs/08-effects-data.md):
///   J = sum over lights of intensity * transmittance * sum over n of albedo^n P_n(tau, g, cos theta),
/// theta between the view ray, which goes away from the eye, and the direction towards the light; per steradian. 0 at
/// points that are not in the mask. To be computed anew for each view; parallel, the result does not depend on the
/// number of threads.
std::vector<double> ambientScattering(const ScatteringData& data, std::span<const Light> lights,
                                      const ScatteredLight& scattered, std::span<const Vec3> points,
                                      const ViewRays& view, PointMask mask = {});

}  // namespace havs
