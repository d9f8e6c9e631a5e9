#include "light/light_data.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/parallel.h"
#include "light/ambient_occlusion.h"
#include "light/ambient_scattering.h"
#include "light/point_gradients.h"
#include "light/scattering_table.h"
#include "light/shadows.h"

namespace havs {
namespace {

Medium mediumOf(const PreparedScene& scene) {
  return {scene.points, scene.mesh.tetrahedra, scene.faces, scene.scalars, scene.facts().cellData, scene.curve};
}

/// The scene that light goes through: of the part that shows anything the whole, of what lies before the eye all.
const PreparedScene& wholeOf(const PreparedScene& drawn) { return drawn.whole != nullptr ? *drawn.whole : drawn; }
const PreparedScene& uncutOf(const PreparedScene& drawn) {
  const PreparedScene& whole = wholeOf(drawn);
  return whole.uncut != nullptr ? *whole.uncut : whole;
}

/// Points of the uncut scene that the drawn points' values come from; empty: all.
std::vector<std::uint8_t> maskOf(const PreparedScene& drawn) {
  const PreparedScene& whole = wholeOf(drawn);
  if (drawn.whole == nullptr && whole.cuts.empty()) return {};
  std::vector<std::uint8_t> mask(whole.points.size(), drawn.whole == nullptr ? 1 : 0);
  if (drawn.whole != nullptr)
    for (const Index p : drawn.pointsInWhole) mask[p] = 1;
  for (std::size_t i = whole.cuts.size(); i-- > 0;) {
    const MeshCut& cut = whole.cuts[i];
    std::vector<std::uint8_t> before(i > 0 ? whole.cuts[i - 1].pointCount() : whole.uncut->points.size(), 0);
    for (std::size_t p = 0; p < mask.size(); ++p) {
      if (mask[p] == 0) continue;
      if (p < cut.keptPoints.size()) {
        before[cut.keptPoints[p]] = 1;
      } else {
        const EdgePoint& point = cut.edgePoints[p - cut.keptPoints.size()];
        before[point.near] = before[point.far] = 1;
      }
    }
    mask = std::move(before);
  }
  return mask;
}

/// A view in the uncut scene's frame.
View uncutView(const PreparedScene& drawn, View view) {
  const PreparedScene& whole = wholeOf(drawn);
  view.eye = whole.origin + whole.axes * view.eye;
  view.center = whole.origin + whole.axes * view.center;
  for (Vec3* const direction : {&view.right, &view.up, &view.forward}) *direction = whole.axes * *direction;
  return view;
}

Light asLight(const ViewLight& light) {
  return {light.atPlace ? Light::Kind::point : Light::Kind::directional, light.place, light.intensity};
}

/// Radii of the mesh: squares of distances stay finite in float.
constexpr double kFarthestLight = 1e18;

ViewLight placed(const SceneLight& light, const LocalFrame& frame, const glm::dmat3& axes, const View& view) {
  ViewLight placed;
  placed.intensity = light.intensity;
  switch (light.kind) {
    case SceneLight::Kind::head:
      placed.atPlace = !view.orthographic;
      placed.place = view.orthographic ? -view.forward : view.eye;
      break;
    case SceneLight::Kind::directional:
      placed.place = asLight({false, light.place * axes, 1}).towards(Vec3(0));
      break;
    case SceneLight::Kind::point:
      placed.atPlace = true;
      placed.place = frame.toLocal(light.place) * axes;
      if (!(length(placed.place / kFarthestLight) <= 1))
        failInput("a light is farther from the mesh than 1e18 of its radii", "lights",
                  "write point:X,Y,Z in mesh units, or directional:X,Y,Z");
      break;
  }
  return placed;
}

bool same(const ViewRays& a, const ViewRays& b) { return a.parallel == b.parallel && a.place == b.place; }

}  // namespace

/// What is known of all points of the whole mesh.
struct LightData::Whole {
  const PreparedScene& drawn;
  const PreparedScene& scene;
  LightPlan plan;
  std::vector<std::uint8_t> mask;
  std::optional<MeshTracer> tracer;
  std::vector<float> rows;  ///< of the points drawn
  std::vector<double> opticalRadius;
  std::optional<ScatteredLight> scattered;
  std::vector<Light> lights;  ///< that shadows and scattering were made for
  ScatteringData scattering;
  std::optional<ViewRays> scatteredFor;  ///< the rays that scattered light was made for
  std::size_t version = 1;

  Whole(const PreparedScene& part, const LightPlan& lightPlan)
      : drawn(part), scene(uncutOf(part)), plan(lightPlan), mask(maskOf(part)) {
    rows.resize(drawn.points.size() * static_cast<std::size_t>(plan.rowLength));
  }

  /// Writes number `at` of each row: valueOf(point of the uncut scene), linear along edges that are cut.
  template <class ValueOf>
  void put(int at, const ValueOf& valueOf) {
    const PreparedScene& whole = wholeOf(drawn);
    std::vector<double> values;
    if (!whole.cuts.empty()) {
      values.resize(scene.points.size());
      parallelFor(0, values.size(), kGrain, [&](std::size_t p) { values[p] = valueOf(p); });
      for (const MeshCut& cut : whole.cuts) values = cut.pointValues(values);
    }
    parallelFor(0, drawn.points.size(), kGrain, [&](std::size_t p) {
      const std::size_t inWhole = drawn.whole != nullptr ? drawn.pointsInWhole[p] : p;
      rows[p * static_cast<std::size_t>(plan.rowLength) + static_cast<std::size_t>(at)] =
          static_cast<float>(values.empty() ? valueOf(inWhole) : values[inWhole]);
    });
  }

  /// The plan's lights in the frame of a scene.
  std::vector<ViewLight> lightsIn(const PreparedScene& seen, const View& view) const {
    std::vector<ViewLight> lights;
    for (const SceneLight& light : plan.lights) lights.push_back(placed(light, seen.frame, wholeOf(seen).axes, view));
    return lights;
  }

  bool traces() const { return plan.occlusionAt >= 0 || plan.scatteredAt >= 0 || plan.shadowsAt >= 0; }

  /// As fractions of the largest of the whole mesh, whatever part is drawn.
  void putGradients() {
    const bool cellData = scene.facts().cellData;
    const PointCells around(scene.points.size(), scene.mesh.tetrahedra);
    const std::vector<Vec3> gradients =
        pointGradients(scene.points, scene.mesh.tetrahedra, around, scene.scalars, cellData);
    double largest = 0;
    for (const Vec3& g : gradients) largest = std::max(largest, dot(g, g));
    const double per = largest > 0 ? 1 / std::sqrt(largest) : 0;
    for (int axis = 0; axis < 3; ++axis)
      put(plan.gradientAt + axis, [&](std::size_t p) { return dot(wholeOf(drawn).axes[axis], gradients[p]) * per; });
  }

  void putBalls() {
    if (plan.occlusion) {
      const BallSetting setting{plan.occlusion->radius, static_cast<std::size_t>(plan.occlusion->directions)};
      const std::vector<double> occlusion = ambientOcclusion(*tracer, setting, mask);
      put(plan.occlusionAt, [&](std::size_t p) { return occlusion[p]; });
    }
  }

  void makeScattered() {
    const AmbientScattering& s = *plan.scattering;
    opticalRadius = ballValues(*tracer, {s.radius, BallSetting{}.directions}, mask).opticalRadius;
    scattered.emplace(*scatteringTableOf(s.anisotropy), s.albedo);
  }
};

LightData::LightData(const PreparedScene& drawn, const LightPlan& plan, StageTimes& stages)
    : whole_(std::make_unique<Whole>(drawn, plan)) {
  if (plan.gradientAt >= 0) {
    const ScopedStage timer(stages, "gradients");
    whole_->putGradients();
  }
  if (!whole_->traces()) return;
  {
    const ScopedStage timer(stages, "tracer");
    whole_->tracer.emplace(mediumOf(whole_->scene));
  }
  if (plan.occlusion) {
    const ScopedStage timer(stages, "occlusion");
    whole_->putBalls();
  }
  if (plan.scattering) {
    const ScopedStage timer(stages, "scattering_table");
    whole_->makeScattered();
  }
}

LightData::~LightData() = default;
LightData::LightData(LightData&&) noexcept = default;

std::size_t LightData::version() const { return whole_->version; }

std::vector<ViewLight> LightData::lightsFor(const View& view) const { return whole_->lightsIn(whole_->drawn, view); }

const std::vector<float>& LightData::rowsFor(const View& seen, StageTimes& stages) {
  Whole& w = *whole_;
  if (w.plan.shadowsAt < 0 && w.plan.scatteredAt < 0) return w.rows;
  std::vector<Light> lights;
  const View view = uncutView(w.drawn, seen);
  for (const ViewLight& light : w.lightsIn(w.scene, view)) lights.push_back(asLight(light));
  const auto sameLight = [](const Light& a, const Light& b) { return a.kind == b.kind && a.place == b.place; };
  const bool moved =
      lights.size() != w.lights.size() || !std::equal(lights.begin(), lights.end(), w.lights.begin(), sameLight);
  w.lights = lights;
  const ViewRays rays{view.orthographic, view.orthographic ? view.forward : view.eye};
  const bool turned = w.plan.scatteredAt >= 0 && !(w.scatteredFor && same(*w.scatteredFor, rays));
  if (moved || turned) ++w.version;
  if (w.plan.shadowsAt >= 0 && moved) {
    const ScopedStage timer(stages, "shadows");
    for (std::size_t i = 0; i < lights.size(); ++i) {
      const std::vector<double> shadow = shadows(*w.tracer, lights[i], w.mask);
      w.put(w.plan.shadowsAt + static_cast<int>(i), [&](std::size_t p) { return shadow[p]; });
    }
  }
  if (w.plan.scatteredAt < 0 || !(moved || turned)) return w.rows;
  w.scatteredFor = rays;
  const ScopedStage timer(stages, "scattering");
  if (moved) w.scattering = scatteringData(*w.tracer, w.opticalRadius, w.plan.scattering->radius, lights, w.mask);
  const std::vector<double> light = ambientScattering(w.scattering, lights, *w.scattered, w.scene.points, rays, w.mask);
  w.put(w.plan.scatteredAt, [&](std::size_t p) { return light[p]; });
  return w.rows;
}

}  // namespace havs
