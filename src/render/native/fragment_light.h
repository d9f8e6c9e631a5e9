#pragma once
// The light that falls on fragments, on SIMD lanes: what shaders/incoming_light.glsl does, by the arithmetic of
// shaders/core/lighting.glsl. Included by tile_kernel.h.
#include "render/native/tile_draw.h"

namespace havs {
namespace {

template <class A, class Lanes>
struct FragmentLight {
  using Real = typename Lanes::Real;
  using Direction = typename A::Direction;

  const TileLight& light;

  /// Of pixels (x, y) of the picture; row(i): the i-th number of the points' rows there; depth: per unit of which
  /// TileLight::along is, `perLength` of it a unit of length.
  template <class Row>
  Real at(Real x, Real y, Real depth, Real perLength, const Row& row) const {
    Real sum = Real(1.0f);
    if (light.phong) {
      const Direction ray = linear(light.along, x, y);
      const typename A::LitPoint point = A::litPoint(gradient(row), A::scaled(ray, Real(0.0f) - perLength));
      sum = Real(light.ambient);
      if (light.occlusionAt >= 0) sum = sum * row(light.occlusionAt);
      for (int i = 0; i < light.lights; ++i) {
        Real from = A::lightFrom(point, towards(i, x, y, depth, ray), light.diffuse, light.specular, light.shininess);
        if (light.shadowsAt >= 0) from = from * row(light.shadowsAt + i);
        sum = sum + Real(light.intensity[i]) * from;
      }
      if (light.silhouettes > 0) sum = sum * A::silhouetteAt(point, light.silhouettes);
    }
    if (light.scatteredAt >= 0) sum = sum + row(light.scatteredAt);
    return sum;
  }

  template <class Row>
  Real densityAt(const Row& row) const {
    if (!light.modulates) return Real(1.0f);
    const Direction g = gradient(row);
    const Real length = Lanes::least(Lanes::squareRoot(A::along(g, g)), Real(1.0f));
    return Real(1.0f - light.modulation) + Real(light.modulation) * length;
  }

 private:
  template <class Row>
  Direction gradient(const Row& row) const {
    return {row(light.gradientAt), row(light.gradientAt + 1), row(light.gradientAt + 2)};
  }

  static Direction linear(const float (&of)[3][3], Real x, Real y) {
    auto number = [&](int axis) { return (Real(of[0][axis]) + Real(of[1][axis]) * x) + Real(of[2][axis]) * y; };
    return {number(0), number(1), number(2)};
  }

  Direction towards(int i, Real x, Real y, Real depth, const Direction& ray) const {
    const float* place = light.place[i];
    if (!light.atPlace[i]) return {Real(place[0]), Real(place[1]), Real(place[2])};
    const Direction base = linear(light.base, x, y);
    const Direction way{Real(place[0]) - (base.x + depth * ray.x), Real(place[1]) - (base.y + depth * ray.y),
                        Real(place[2]) - (base.z + depth * ray.z)};
    const Real squared = A::along(way, way);
    const auto away = squared > Real(0.0f);
    return A::scaled(
        way, Lanes::select(away, Real(1.0f) / Lanes::squareRoot(Lanes::select(away, squared, Real(1.0f))), Real(0.0f)));
  }
};

}  // namespace
}  // namespace havs
