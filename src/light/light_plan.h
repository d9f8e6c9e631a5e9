#pragma once
#include <optional>
#include <vector>

#include "scene/lighting.h"

namespace havs {

/// What the light of fragments is made of. Numbers that belong to the mesh's points lie in rows, one row a point: those
/// that the scene calls for.
struct LightPlan {
  bool lit = false;    ///< fragments carry light at all
  bool phong = false;  ///< ambient, diffuse and specular terms; else only scattered light is added to 1
  Lighting lighting;
  std::vector<SceneLight> lights;
  double modulation = 0;  ///< extinction times 1 - modulation + modulation * |gradient| / largest
  std::optional<AmbientOcclusion> occlusion;
  std::optional<AmbientScattering> scattering;

  // Places in a row; -1: not there.
  int gradientAt = -1;  ///< three numbers, a fraction of the largest gradient
  int occlusionAt = -1;
  int scatteredAt = -1;
  int shadowsAt = -1;  ///< one number a light
  int rowLength = 0;
};

}  // namespace havs
