#include "reference/lit_ray.h"

#include <algorithm>
#include <cmath>

#include "reference/crossings.h"
#include "reference/ray_surface.h"
#include "transfer/pieces.h"
#include "transfer/preintegration.h"

namespace havs {
namespace {

using A = DoubleArithmetic;
using Incident = LitRays::Incident;

/// On [0, 1], eight points: exact for polynomials up to degree 15.
constexpr int kNodes = 8;
constexpr double kNode[kNodes] = {0.01985507175123188, 0.10166676129318664, 0.2372337950418355, 0.4082826787521751,
                                  0.5917173212478249,  0.7627662049581645,  0.8983332387068134, 0.9801449282487681};
constexpr double kWeight[kNodes] = {0.05061426814518813, 0.11119051722668724, 0.15685332293894363, 0.18134189168918100,
                                    0.18134189168918100, 0.15685332293894363, 0.11119051722668724, 0.05061426814518813};
constexpr double kStepDepth = 0.5;  // of a step of the quadrature: the rest of the series is below 1e-16
constexpr double kUsedUp = 1e-18;   // nothing shows through

A::Direction direction(const Vec3& v) { return {v.x, v.y, v.z}; }

/// What is linear along a stretch: colour and kappa, light, density.
struct End {
  Rgba sample;
  Incident incident;
};

double between(double a, double b, double share) { return a + share * (b - a); }
End between(const End& a, const End& b, double share) {
  auto mix = [share](double x, double y) { return between(x, y, share); };
  return {{mix(a.sample.r, b.sample.r), mix(a.sample.g, b.sample.g), mix(a.sample.b, b.sample.b),
           mix(a.sample.a, b.sample.a)},
          {mix(a.incident.light, b.incident.light), mix(a.incident.density, b.incident.density)}};
}

/// Under `sum`, a stretch of at most kStepDepth.
void addStep(Rgba& sum, const End& front, const End& back, double length) {
  const double k0 = front.sample.a * length, k1 = back.sample.a * length - k0;
  const double m0 = front.incident.density, m1 = back.incident.density - m0;
  const auto depthTo = [&](double u) { return u * (k0 * m0 + u * ((k0 * m1 + k1 * m0) / 2 + u * (k1 * m1 / 3))); };
  Rgba step(0, 0, 0, -std::expm1(-depthTo(1)));
  for (int i = 0; i < kNodes; ++i) {
    const double u = kNode[i];
    const End at = between(front, back, u);
    const double light =
        kWeight[i] * at.sample.a * length * at.incident.density * at.incident.light * std::exp(-depthTo(u));
    step.r += light * at.sample.r;
    step.g += light * at.sample.g;
    step.b += light * at.sample.b;
  }
  sum = A::compositeUnder(sum, step);
}

void addPiece(Rgba& sum, const End& front, const End& back, double length) {
  const double most =
      std::max(front.sample.a, back.sample.a) * std::max(front.incident.density, back.incident.density) * length;
  const double steps = std::max(1.0, std::ceil(most / kStepDepth));
  for (double i = 0; i < steps && 1 - sum.a > kUsedUp; ++i)
    addStep(sum, between(front, back, i / steps), between(front, back, (i + 1) / steps), length / steps);
}

void addSegment(Rgba& sum, const ExtinctionCurve& curve, double from, double to, double length, const Incident& front,
                const Incident& back) {
  from = std::clamp(from, 0.0, 1.0);
  to = std::clamp(to, 0.0, 1.0);
  const End ends[2] = {{{}, front}, {{}, back}};
  if (from == to) {
    const ExtinctionCurve::Knot k = curve.at(from);
    const Rgba sample(k.color[0], k.color[1], k.color[2], k.kappa);
    return addPiece(sum, {sample, front}, {sample, back}, length);
  }
  const double whole = std::abs(to - from);
  double done = 0;
  visitPieces(curve, from, to, [&](const Rgba& near, const Rgba& far, double extent) {
    const double next = done + extent / whole;
    addPiece(sum, {near, between(ends[0], ends[1], done).incident}, {far, between(ends[0], ends[1], next).incident},
             extent / whole * length);
    done = next;
  });
}

/// A segment being gone through, from where it has come to.
struct LitStretch {
  double scalar, share;
  Incident incident;
};

/// Under `sum`, the volume up to `end`, from where the stretch has come to; `length`: of the whole segment. Whether an
/// opaque surface ends the ray.
bool addVolume(Rgba& sum, const ExtinctionCurve& curve, const LitStretch& begin, const LitStretch& end, double length) {
  const double part = (end.share - begin.share) * length;
  const RaySurface surface = firstSurface(curve, begin.scalar, end.scalar);
  if (surface.share > 1) {
    addSegment(sum, curve, begin.scalar, end.scalar, part, begin.incident, end.incident);
    return false;
  }
  const Incident met = between({{}, begin.incident}, {{}, end.incident}, surface.share).incident;
  addSegment(sum, curve, begin.scalar, surface.scalar, surface.share * part, begin.incident, met);
  const Rgba color = colorOfSurface(curve, surface);
  sum = A::compositeUnder(sum, {color.r * met.light, color.g * met.light, color.b * met.light, color.a});
  return true;
}

/// The same with an isosurface.
bool addSurface(Rgba& sum, const ShownIsosurface& surface, double light) {
  const auto& [r, g, b] = surface.color;
  const double a = surface.opacity;
  sum = A::compositeUnder(sum, {a * light * r, a * light * g, a * light * b, a});
  return a >= 1;
}

}  // namespace

LitRays::LitRays(const PreparedScene& prepared, const LightPlan& plan, const std::vector<float>& rows,
                 std::vector<ViewLight> lights, const View& view, bool volume)
    : prepared_(prepared), plan_(plan), rows_(rows), lights_(std::move(lights)), view_(view), volume_(volume) {}

Incident LitRays::incidentAt(const Vec3& place, Index cell, const Vec3& toEye) const {
  const Tetrahedron& corners = prepared_.mesh.tetrahedra[cell];
  std::array<Vec3, 4> r;
  for (std::size_t i = 0; i < 4; ++i) r[i] = prepared_.points[corners[i]] - place;
  auto volume = [&](int i, int j, int k) { return dot(cross(r[i], r[j]), r[k]); };
  std::array<double, 4> weight{volume(1, 2, 3), -volume(0, 2, 3), volume(0, 1, 3), -volume(0, 1, 2)};
  const double sum = weight[0] + weight[1] + weight[2] + weight[3];
  for (double& w : weight) w = sum != 0 ? w / sum : 0.25;
  const auto row = [&](int number) {
    double value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value +=
          weight[i] * static_cast<double>(rows_[std::size_t{corners[i]} * static_cast<std::size_t>(plan_.rowLength) +
                                                static_cast<std::size_t>(number)]);
    return value;
  };

  Incident incident;
  A::Direction gradient{0, 0, 0};
  if (plan_.gradientAt >= 0) gradient = {row(plan_.gradientAt), row(plan_.gradientAt + 1), row(plan_.gradientAt + 2)};
  if (plan_.phong) {
    const Lighting& l = plan_.lighting;
    const A::LitPoint point = A::litPoint(gradient, direction(toEye));
    incident.light = l.ambient * (plan_.occlusionAt >= 0 ? row(plan_.occlusionAt) : 1);
    for (std::size_t i = 0; i < lights_.size(); ++i) {
      Vec3 toLight = lights_[i].place;
      if (lights_[i].atPlace) {
        const Vec3 way = lights_[i].place - place;
        toLight = dot(way, way) > 0 ? normalize(way) : Vec3(0.0);
      }
      const double shadow = plan_.shadowsAt >= 0 ? row(plan_.shadowsAt + static_cast<int>(i)) : 1;
      incident.light +=
          lights_[i].intensity * shadow * A::lightFrom(point, direction(toLight), l.diffuse, l.specular, l.shininess);
    }
    incident.light *= A::silhouetteAt(point, l.silhouettes);
  }
  if (plan_.scatteredAt >= 0) incident.light += row(plan_.scatteredAt);
  if (plan_.modulation > 0)
    incident.density = 1 - plan_.modulation + plan_.modulation * std::min(1.0, std::sqrt(A::along(gradient, gradient)));
  return incident;
}

RayColor LitRays::color(int x, int y, std::span<const CellSegment> segments, std::span<const RayLayer> onRay) const {
  const double scale = view_.rayScale(x + 0.5, y + 0.5);
  const double u = (2 * (x + 0.5) / view_.width - 1) * view_.halfWidth;
  const double v = (1 - 2 * (y + 0.5) / view_.height) * view_.halfHeight;
  const Vec3 across = u * view_.right + v * view_.up;
  const Vec3 along = view_.orthographic ? view_.forward : view_.forward + across;
  const double reach = view_.orthographic ? 1.0 : -view_.depth(view_.eye);
  const Vec3 base = view_.center - view_.depth(view_.center) * view_.forward + reach * across;  // at depth 0
  const Vec3 toEye = -along / scale;
  Rgba sum(0, 0, 0, 0);
  Crossings crossings(prepared_.isosurfaces);
  LayersOfRay layers(onRay);
  const auto under = [&](const std::array<float, 4>& rgba) { sum = A::compositeUnder(sum, colorOfLayer(rgba)); };
  for (const CellSegment& s : segments) {
    layers.before(middleOf(s), under);
    const Incident front = incidentAt(base + s.entry / scale * along, s.cell, toEye);
    const Incident back = incidentAt(base + s.exit / scale * along, s.cell, toEye);
    const double length = s.exit - s.entry;
    LitStretch begin{s.scalarEntry, 0, front};
    bool ended = false;
    crossings.visit(s, [&](const ShownIsosurface& surface, double share) {
      const LitStretch met{surface.scalar, share, between({{}, front}, {{}, back}, share).incident};
      ended = ended || (volume_ && addVolume(sum, prepared_.curve, begin, met, length)) ||
              addSurface(sum, surface, met.incident.light);
      begin = met;
    });
    if (ended || (volume_ && addVolume(sum, prepared_.curve, begin, {s.scalarExit, 1, back}, length))) break;
  }
  layers.rest(under);
  return {sum.r, sum.g, sum.b, sum.a};
}

}  // namespace havs
