#include "light/ambient_scattering.h"

#include "core/parallel.h"

namespace havs {

ScatteringData scatteringData(const MeshTracer& tracer, std::vector<double> opticalRadius, double radius,
                              std::span<const Light> lights, PointMask mask) {
  ScatteringData data{std::move(opticalRadius), {}};
  for (const Light& light : lights) data.transmittance.push_back(shadows(tracer, light, mask, radius));
  return data;
}

Vec3 ViewRays::at(const Vec3& point) const {
  if (parallel) return place;
  const Vec3 way = point - place;
  const double distance = length(way);
  return distance > 0 ? way / distance : Vec3(0);
}

std::vector<double> ambientScattering(const ScatteringData& data, std::span<const Light> lights,
                                      const ScatteredLight& scattered, std::span<const Vec3> points,
                                      const ViewRays& view, PointMask mask) {
  constexpr std::size_t kPoints = 1024;
  std::vector<double> sums(points.size(), 0.0);
  parallelFor(0, points.size(), kPoints, [&](std::size_t p) {
    if (!isIn(mask, p)) return;
    const Vec3 ray = view.at(points[p]);
    for (std::size_t l = 0; l < lights.size(); ++l) {
      const double light = lights[l].intensity * data.transmittance[l][p];
      if (light != 0) sums[p] += light * scattered(data.opticalRadius[p], dot(ray, lights[l].towards(points[p])));
    }
  });
  return sums;
}

}  // namespace havs
