#pragma once
// The light of fragments as the tile kernels need it: plain data (light/light_plan.h, light/light_data.h).
namespace havs {

inline constexpr int kMostTileLights = 4;
inline constexpr int kMostRowNumbers = 9;  ///< gradient, occlusion, scattered light, a shadow of each light

struct TileLight {
  const float* rows;  ///< one a point
  int rowLength;
  int gradientAt, occlusionAt, scatteredAt, shadowsAt;  ///< places in a row; -1: not there
  bool phong;
  bool modulates;
  float ambient, diffuse, specular, silhouettes, modulation;
  int shininess;
  int lights;
  bool atPlace[kMostTileLights];  ///< else `place` is the direction, of length 1
  float place[kMostTileLights][3];
  float intensity[kMostTileLights];
  /// The ray of a pixel per unit of depth, and where it passes the plane of depth 0: at the first pixel of the picture,
  /// and by how much they change from one to the next across and down.
  float along[3][3];
  float base[3][3];
};

}  // namespace havs
