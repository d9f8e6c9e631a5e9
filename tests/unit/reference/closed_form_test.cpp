// The reference in double against closed forms: at most 1e-12 off (1e-10 is what was asked). The roundings that add
// up to it: of the picture's coordinates, times the slope of a face (cell_segments_test.cpp), times the extinction.
#include <gtest/gtest.h>

#include <numbers>

#include "unit/gauss_kronrod.h"
#include "unit/reference/rays.h"

namespace havs::test {
namespace {

constexpr double kBound = 1e-12;
constexpr double kKappa = 0.9;

RayColor constantColor(double length, double kappa = kKappa) {
  const double alpha = -std::expm1(-kappa * length);
  return {0.8 * alpha, 0.4 * alpha, 0.2 * alpha, alpha};
}

/// Of a mesh of one value under constant extinction, whose rays have the given length.
void expectLengths(const TetMesh& mesh, const std::function<double(const Ray&)>& length, std::size_t leastSeen) {
  const PreparedScene scene = sceneOf(mesh, constantField(mesh.points, 0.3), constantCurve(kKappa));
  for (const View& view : obliqueViews(70)) {
    const Deviation d = deviation(scene, view, [&](int x, int y) { return constantColor(length(rayOf(view, x, y))); });
    EXPECT_LE(d.most, kBound) << d;
    EXPECT_GT(d.seen, leastSeen);
  }
}

double inCube(const Ray& ray, double half) { return throughBox(ray, Vec3(-half), Vec3(half)).length(); }

TEST(ReferenceClosedForm, ConstantBox) {
  expectLengths(
      box(5, Cut::six, 0.25), [](const Ray& ray) { return inCube(ray, 1); }, 1500);
}

TEST(ReferenceClosedForm, OneCell) {
  const double third = 1 / std::sqrt(3.0);
  auto length = [=](const Ray& ray) {
    return clip(ray, {{{1, 0, 0}, 0}, {{0, 1, 0}, 0}, {{0, 0, 1}, 0}, {Vec3(-third), third}}).length();
  };
  expectLengths(singleTetrahedron(), length, 100);
}

TEST(ReferenceClosedForm, NestedShells) {
  expectLengths(
      nestedShells(5), [](const Ray& ray) { return inCube(ray, 1) - inCube(ray, 0.6) + inCube(ray, 0.3); }, 1500);
}

TEST(ReferenceClosedForm, BoxesThatTouchAndBoxesWithAGap) {
  for (const double gap : {0.0, 1e-12, 1e-4, 0.2})
    expectLengths(
        twoBoxes(3, gap),
        [=](const Ray& ray) {
          return throughBox(ray, {-1, -1, -1}, {0, 1, 1}).length() +
                 throughBox(ray, {gap, -1, -1}, {1 + gap, 1, 1}).length();
        },
        1500);
}

// Parts of a mesh that meet without sharing points, each of its own value: no cell sees the other part's scalars.
TEST(ReferenceClosedForm, BoxesThatTouchKeepTheirOwnScalars) {
  const TetMesh mesh = twoBoxes(3, 0.0);
  std::vector<double> scalars(mesh.points.size(), 0.1);
  std::fill(scalars.begin() + static_cast<std::ptrdiff_t>(scalars.size() / 2), scalars.end(), 0.8);
  const PreparedScene scene = sceneOf(mesh, scalars, rampCurve(0.3, 2.3));
  for (const View& view : obliqueViews(70)) {
    const Deviation d = deviation(scene, view, [&](int x, int y) {
      const Ray ray = rayOf(view, x, y);
      auto part = [&](double low, double scalar) {
        const auto sample = scene.curve.at(scalar);
        const double alpha = -std::expm1(-sample.kappa * throughBox(ray, {low, -1, -1}, {low + 1, 1, 1}).length());
        return RayColor{sample.color[0] * alpha, sample.color[1] * alpha, sample.color[2] * alpha, alpha};
      };
      const RayColor left = part(-1, 0.1), right = part(0, 0.8);
      return ray.direction.x > 0 ? over(left, right) : over(right, left);
    });
    EXPECT_LE(d.most, kBound) << d;
    EXPECT_GT(d.seen, 1500u);
  }
}

TEST(ReferenceClosedForm, OGrid) {
  constexpr int kAround = 11;
  // A prism over a polygon of kAround corners at radius r: the mesh is the outer one less the inner one.
  auto inPrism = [](const Ray& ray, double r) {
    std::vector<HalfSpace> halves{{{0, 0, 1}, 0.5}, {{0, 0, -1}, 0.5}};
    for (int j = 0; j < kAround; ++j) {
      const double angle = 2 * std::numbers::pi * (j + 0.5) / kAround;
      halves.push_back({{-std::cos(angle), -std::sin(angle), 0}, r * std::cos(std::numbers::pi / kAround)});
    }
    return clip(ray, halves).length();
  };
  expectLengths(
      oGrid(3, kAround, 2), [&](const Ray& ray) { return inPrism(ray, 1) - inPrism(ray, 0.4); }, 1000);
}

/// Colour and extinction linear along a ray from s = `from` to `to`: by erf where the extinction rises, by quadrature
/// of the definition elsewhere.
RayColor rampColor(const ExtinctionCurve& curve, double from, double to, double length) {
  const auto front = curve.at(from), back = curve.at(to);
  const long double a = length * front.kappa, b = length * (back.kappa - front.kappa) / 2;
  const long double zeta = std::exp(-(a + b));
  long double psi = 0;
  if (b > 0.05L) {
    const long double root = std::sqrt(b), shift = a / (2 * root);
    psi = std::sqrt(std::numbers::pi_v<long double>) / (2 * root) * std::exp(shift * shift) *
          (std::erf(root + shift) - std::erf(shift));
  } else {
    psi = integrate([=](long double s) { return std::exp(-(a * s + b * s * s)); }, 0, 1);
  }
  RayColor color{0, 0, 0, static_cast<double>(1 - zeta)};
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = static_cast<double>(front.color[c] * (1 - psi) + back.color[c] * (psi - zeta));
  return color;
}

TEST(ReferenceClosedForm, LinearRampsOfColourAndExtinction) {
  const TetMesh mesh = box(5, Cut::five, 0.25);
  const Vec3 gradient{0.1, 0.3, 0.08};  // within [0, 1] on [-1, 1]^3
  for (const auto& [kappa0, kappa1] : {std::pair{0.0, 2.0}, {3.0, 0.5}, {20.0, 60.0}}) {
    const PreparedScene scene = sceneOf(mesh, linearField(mesh.points, gradient), rampCurve(kappa0, kappa1));
    for (const View& view : obliqueViews(60)) {
      const Deviation d = deviation(scene, view, [&](int x, int y) {
        const Ray ray = rayOf(view, x, y);
        const Stretch chord = throughBox(ray, Vec3(-1.0), Vec3(1.0));
        auto scalar = [&](double t) { return 0.5 + dot(gradient, ray.origin + t * ray.direction); };
        return chord.length() > 0 ? rampColor(scene.curve, scalar(chord.first), scalar(chord.last), chord.length())
                                  : RayColor{};
      });
      EXPECT_LE(d.most, kBound) << d;
      EXPECT_GT(d.seen, 1000u);
    }
  }
}

TEST(ReferenceClosedForm, StepsOfTheTransferFunction) {
  ExtinctionCurve curve;  // red below 0.4, green to 0.7, blue above, each of its own extinction
  curve.knots = {{0, {1, 0, 0}, 0.5},   {0.4, {1, 0, 0}, 0.5}, {0.4, {0, 1, 0}, 2},
                 {0.7, {0, 1, 0}, 2.0}, {0.7, {0, 0, 1}, 1},   {1, {0, 0, 1}, 1}};
  const TetMesh mesh = box(5, Cut::six, 0.25);
  for (const double gradient : {0.5, -0.5}) {  // s = 0.5 + gradient x
    const PreparedScene scene = sceneOf(mesh, linearField(mesh.points, {gradient, 0, 0}), curve);
    const double x1 = (0.4 - 0.5) / gradient, x2 = (0.7 - 0.5) / gradient;
    struct Slab {
      double low, high;
      RayColor color;
      double kappa;
    };
    const std::vector<Slab> slabs{{gradient > 0 ? -1 : x1, gradient > 0 ? x1 : 1, {1, 0, 0, 1}, 0.5},
                                  {std::min(x1, x2), std::max(x1, x2), {0, 1, 0, 1}, 2.0},
                                  {gradient > 0 ? x2 : -1, gradient > 0 ? 1 : x2, {0, 0, 1, 1}, 1.0}};
    for (const View& view : obliqueViews(60)) {
      const Deviation d = deviation(scene, view, [&](int x, int y) {
        const Ray ray = rayOf(view, x, y);
        std::vector<std::pair<double, RayColor>> parts;
        for (const Slab& slab : slabs) {
          const Stretch s = throughBox(ray, {slab.low, -1, -1}, {slab.high, 1, 1});
          RayColor color = slab.color;
          for (double& c : color) c *= -std::expm1(-slab.kappa * s.length());
          parts.emplace_back(s.first, color);
        }
        std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        return over(over(parts[0].second, parts[1].second), parts[2].second);
      });
      EXPECT_LE(d.most, kBound) << d;
    }
  }
}

TEST(ReferenceClosedForm, CellDataIsConstantInACell) {
  const TetMesh mesh = box(4, Cut::five);
  std::vector<double> values;
  for (const Tetrahedron& cell : mesh.tetrahedra) {
    double x = 0;
    for (const Index p : cell) x += mesh.points[p].x;
    values.push_back(x < 0 ? 0.2 : 0.9);  // the plane x = 0 is one of the grid's
  }
  const ExtinctionCurve curve = rampCurve(0.3, 2.3);
  const PreparedScene scene = sceneOf(mesh, values, curve, Centering::cell);
  for (const View& view : obliqueViews(60)) {
    const Deviation d = deviation(scene, view, [&](int x, int y) {
      const Ray ray = rayOf(view, x, y);
      auto part = [&](double low, double high, double scalar) {
        const double length = throughBox(ray, {low, -1, -1}, {high, 1, 1}).length();
        const auto sample = curve.at(scalar);
        const double alpha = -std::expm1(-sample.kappa * length);
        return RayColor{sample.color[0] * alpha, sample.color[1] * alpha, sample.color[2] * alpha, alpha};
      };
      const RayColor left = part(-1, 0, 0.2), right = part(0, 1, 0.9);
      return ray.direction.x > 0 ? over(left, right) : over(right, left);
    });
    EXPECT_LE(d.most, kBound) << d;
    EXPECT_GT(d.seen, 1000u);
  }
}

/// A haze of extinction 0.7 and a surface where the scalar lies in [0.4, 0.6], its colour at both steps the surface's.
ExtinctionCurve surfaceCurve() {
  constexpr double kCap = 300;
  ExtinctionCurve curve;
  curve.knots = {{0, {0, 0, 1}, 0.7},    {0.4, {0, 0, 1}, 0.7}, {0.4, {1, 0, 0}, kCap},
                 {0.6, {0, 1, 0}, kCap}, {0.6, {1, 1, 0}, 0.7}, {1, {1, 1, 0}, 0.7}};
  curve.opaque = {{0.4, 0.6}};
  return curve;
}

TEST(ReferenceClosedForm, OpaqueSurfaceEndsTheRay) {
  const TetMesh mesh = box(5, Cut::six, 0.25);
  for (const Vec3& gradient : {Vec3{0.5, 0, 0}, {-0.5, 0, 0}, {0, 0, 0.5}}) {
    const PreparedScene scene = sceneOf(mesh, linearField(mesh.points, gradient), surfaceCurve());
    for (const View& view : obliqueViews(60)) {
      std::size_t surfaces = 0;
      const Deviation d = deviation(scene, view, [&](int x, int y) {
        const Ray ray = rayOf(view, x, y);
        const Stretch chord = throughBox(ray, Vec3(-1.0), Vec3(1.0));
        if (chord.length() == 0) return RayColor{};
        const double at0 = 0.5 + dot(gradient, ray.origin), slope = dot(gradient, ray.direction);
        const double entry = at0 + slope * chord.first;
        const RayColor haze = entry < 0.4 ? RayColor{0, 0, 1, 1} : RayColor{1, 1, 0, 1};
        RayColor surface = entry < 0.4 ? RayColor{1, 0, 0, 1} : RayColor{0, 1, 0, 1};
        double reached = ((entry < 0.4 ? 0.4 : 0.6) - at0) / slope;
        if (entry >= 0.4 && entry <= 0.6) {
          reached = chord.first;
          surface = {5 * (0.6 - entry), 5 * (entry - 0.4), 0, 1};
        }
        const bool hit = reached >= chord.first && reached <= chord.last;
        RayColor color = haze;
        for (double& c : color) c *= -std::expm1(-0.7 * ((hit ? reached : chord.last) - chord.first));
        surfaces += hit;
        return hit ? over(color, surface) : color;
      });
      EXPECT_LE(d.most, kBound) << d;
      EXPECT_GT(surfaces, 500u);
    }
  }
}

TEST(ReferenceClosedForm, OpaqueAtOneScalarOnly) {
  // A peak that reaches opacity 1 at 0.5: met by every ray that passes it, though no interval has a width.
  ExtinctionCurve curve;
  curve.knots = {
      {0, {1, 1, 1}, 0}, {0.5, {1, 1, 1}, 0}, {0.5, {0.3, 0.6, 0.9}, 400}, {0.5, {1, 1, 1}, 0}, {1, {1, 1, 1}, 0}};
  curve.opaque = {{0.5, 0.5}};
  const TetMesh mesh = box(4, Cut::five, 0.2);
  const PreparedScene scene = sceneOf(mesh, linearField(mesh.points, {0.5, 0, 0}), curve);
  for (const View& view : obliqueViews(60)) {
    const Deviation d = deviation(scene, view, [&](int x, int y) {
      const Stretch plane = throughBox(rayOf(view, x, y), {-1, -1, -1}, {0, 1, 1});
      const Stretch other = throughBox(rayOf(view, x, y), {0, -1, -1}, {1, 1, 1});
      return plane.length() > 0 && other.length() > 0 ? RayColor{0.3, 0.6, 0.9, 1} : RayColor{};
    });
    EXPECT_LE(d.most, kBound) << d;
    EXPECT_GT(d.seen, 300u);
  }
}

}  // namespace
}  // namespace havs::test
