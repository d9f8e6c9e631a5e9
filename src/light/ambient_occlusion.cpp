#include "light/ambient_occlusion.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "light/directions.h"
#include "light/each_point.h"

namespace havs {
namespace {

std::vector<Vec3> directionsOf(const BallSetting& setting) {
  if (!(setting.radius > 0 && std::isfinite(setting.radius)))
    failInput(fmt::format("radius {} of the ambient light is not positive", setting.radius), "",
              "give it in bounding radii, as 0.1");
  if (setting.directions == 0) failInput("ambient light needs at least one direction", "", "64 are usual");
  return fibonacciDirections(setting.directions);
}

}  // namespace

std::vector<double> ambientOcclusion(const MeshTracer& tracer, const BallSetting& setting, PointMask mask) {
  const std::vector<Vec3> directions = directionsOf(setting);
  std::vector<double> occlusion(tracer.medium().points.size(), 1.0);
  forEachPoint(tracer, mask, [&](PointRays& rays, std::size_t p) {
    double sum = 0;
    for (const Vec3& direction : directions) sum += rays.transmittance(direction, 0, setting.radius);
    occlusion[p] = sum / static_cast<double>(directions.size());
  });
  return occlusion;
}

BallValues ballValues(const MeshTracer& tracer, const BallSetting& setting, PointMask mask) {
  const std::vector<Vec3> directions = directionsOf(setting);
  const std::size_t count = tracer.medium().points.size();
  BallValues values{std::vector<double>(count, 1.0), std::vector<double>(count, 0.0)};
  const auto rayCount = static_cast<double>(directions.size());
  forEachPoint(tracer, mask, [&](PointRays& rays, std::size_t p) {
    double sum = 0, moment = 0;
    for (const Vec3& direction : directions) {
      const PointRays::BallRay ray = rays.ballRay(direction, setting.radius);
      sum += std::exp(-ray.opticalDepth);
      moment += ray.moment;
    }
    values.occlusion[p] = sum / rayCount;
    values.opticalRadius[p] = 3 / (setting.radius * setting.radius) * moment / rayCount;
  });
  return values;
}

}  // namespace havs
