#pragma once
#include <vector>

#include "light/mesh_tracer.h"

namespace havs {

/// The ball about each point, and the rays that look into it.
struct BallSetting {
  double radius = 0.1;          ///< local units (bounding radii), > 0
  std::size_t directions = 64;  ///< fibonacciDirections; at least 1
};

/// Ambient occlusion at each point, 0 to 1: the mean over the directions of exp(-optical depth over the radius);
/// outside the mesh nothing occludes (after Hernell, Ljung, Ynnerman 2010, Local Ambient Occlusion in Direct
/// Volume Rendering). 1 at points that are not in the mask. Throws Error{input} for settings out of range. Parallel;
/// the result does not depend on the number of threads.
std::vector<double> ambientOcclusion(const MeshTracer& tracer, const BallSetting& setting = {}, PointMask mask = {});

struct BallValues {
  std::vector<double> occlusion;      ///< as above
  std::vector<double> opticalRadius;  ///< radius times the mean of kappa over the ball (by volume, 0 outside the mesh)
};

/// Both from the same rays. Points that are not in the mask have 1 and 0.
BallValues ballValues(const MeshTracer& tracer, const BallSetting& setting = {}, PointMask mask = {});

}  // namespace havs
