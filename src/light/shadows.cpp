#include "light/shadows.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "light/each_point.h"

namespace havs {

Vec3 Light::towards(const Vec3& point) const {
  const Vec3 way = kind == Kind::directional ? place : place - point;
  const double largest = std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)});
  return largest > 0 ? normalize(way / largest) : Vec3(0);  // first divided, so that no square overflows or underflows
}

double Light::distance(const Vec3& point) const {
  return kind == Kind::directional ? PointRays::kEndless : length(place - point);
}

std::vector<double> shadows(const MeshTracer& tracer, const Light& light, PointMask mask, double from) {
  if (!isFinite(light.place)) failInput("the place of a light is not finite", "", "give three numbers");
  if (light.kind == Light::Kind::directional && light.place == Vec3(0))
    failInput("a directional light has no direction", "", "give a direction towards it, as 0 1 0");
  const std::span<const Vec3> points = tracer.medium().points;
  std::vector<double> transmittances(points.size(), 1.0);
  forEachPoint(tracer, mask, [&](PointRays& rays, std::size_t p) {
    const double distance = light.distance(points[p]);
    if (distance > 0) transmittances[p] = rays.transmittance(light.towards(points[p]), from, distance);
  });
  return transmittances;
}

}  // namespace havs
