#include "render/native/tile_light_data.h"

#include "scene/lighting.h"

namespace havs {
namespace {

static_assert(kMostTileLights == kMostLights);
static_assert(kMostRowNumbers == 3 + 1 + 1 + kMostLights);

void copy(const Vec3& from, float (&to)[3]) {
  for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(from[i]);
}

/// The rays' directions per unit of depth, and where they pass the plane of depth 0, across the picture.
void setRays(const View& view, TileLight& light) {
  const Vec3 perX = (2 * view.halfWidth / view.width) * view.right;
  const Vec3 perY = (-2 * view.halfHeight / view.height) * view.up;
  const Vec3 across = 0.5 * perX - view.halfWidth * view.right + 0.5 * perY + view.halfHeight * view.up;
  const double reach = view.orthographic ? 1.0 : -view.depth(view.eye);
  const Vec3 zero(0.0);
  const Vec3 along = view.orthographic ? view.forward : view.forward + across;
  copy(along, light.along[0]);
  copy(view.orthographic ? zero : perX, light.along[1]);
  copy(view.orthographic ? zero : perY, light.along[2]);
  copy(view.center - view.depth(view.center) * view.forward + reach * across, light.base[0]);
  copy(reach * perX, light.base[1]);
  copy(reach * perY, light.base[2]);
}

}  // namespace

TileLight tileLight(const LightPlan& plan, const std::vector<float>& rows, const std::vector<ViewLight>& lights,
                    const View& view) {
  TileLight light{};
  light.rows = rows.data();
  light.rowLength = plan.rowLength;
  light.gradientAt = plan.gradientAt;
  light.occlusionAt = plan.occlusionAt;
  light.scatteredAt = plan.scatteredAt;
  light.shadowsAt = plan.shadowsAt;
  light.phong = plan.phong;
  light.modulates = plan.modulation > 0;
  light.ambient = static_cast<float>(plan.lighting.ambient);
  light.diffuse = static_cast<float>(plan.lighting.diffuse);
  light.specular = static_cast<float>(plan.lighting.specular);
  light.silhouettes = static_cast<float>(plan.lighting.silhouettes);
  light.shininess = plan.lighting.shininess;
  light.modulation = static_cast<float>(plan.modulation);
  light.lights = static_cast<int>(lights.size());
  for (std::size_t i = 0; i < lights.size(); ++i) {
    light.atPlace[i] = lights[i].atPlace;
    copy(lights[i].place, light.place[i]);
    light.intensity[i] = static_cast<float>(lights[i].intensity);
  }
  setRays(view, light);
  return light;
}

}  // namespace havs
