#pragma once
#include "core/vec.h"

namespace havs {

/// How light falls on the volume (docs/03-scene.md, Lighting). The colour at a point is multiplied by
///   ambient * occlusion + sum over lights of intensity (diffuse |n.l| + specular (r.v)^shininess) * shadow,
/// n the normalised gradient of the scalar, and by 1 - silhouettes (1 - |n.v|)^2. Coefficients are >= 0.
struct Lighting {
  double ambient = 0.2;
  double diffuse = 0.5;
  double specular = 0.3;
  int shininess = 5;       ///< 0 to 1000
  double silhouettes = 0;  ///< 0 to 1
};

/// A light as a user places it.
struct SceneLight {
  enum class Kind {
    head,         ///< at the eye; for parallel rays behind it
    directional,  ///< far away; `place` points towards it
    point         ///< at `place`, in mesh units; does not fade with distance
  };
  Kind kind = Kind::head;
  Vec3 place{0, 0, 1};
  double intensity = 1;
};

/// Of the ambient light, what comes through the mesh from all around, no farther than the radius.
struct AmbientOcclusion {
  double radius = 0.1;  ///< of the bounding radius, > 0
  int directions = 64;  ///< 1 to 4096
};

/// Light that is scattered many times around a point (Ament, Sadlo, Weiskopf 2013).
struct AmbientScattering {
  double albedo = 0.9;    ///< 0 to below 1
  double anisotropy = 0;  ///< Henyey and Greenstein's g, -0.95 to 0.95
  double radius = 0.1;    ///< of the bounding radius, > 0
};

inline constexpr int kMostLights = 4;

}  // namespace havs
