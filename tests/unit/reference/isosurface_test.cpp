// Isosurfaces in the reference: a linear field has planes, so every pixel is known.
#include <gtest/gtest.h>

#include "unit/reference/rays.h"

namespace havs::test {
namespace {

/// Roundings of the picture's coordinates in double, and of distances of order 1 (closed_form_test.cpp).
constexpr double kSurfaceBound = 1e-12;
constexpr Color kOrange{1, 0.5, 0};
constexpr Color kBlue{0.1, 0.2, 0.9};

/// Rays of the views rise along it.
const Vec3 kGradient{-0.17, -0.05, -0.12};

/// A box whose field is 0.5 + dot(gradient, p).
struct LinearScene {
  Vec3 gradient;
  PreparedScene prepared;
  LinearScene(const Vec3& gradient_, std::vector<ShownIsosurface> surfaces, const ExtinctionCurve& curve)
      : gradient(gradient_) {
    const TetMesh mesh = box(5, Cut::six, 0.25);
    prepared = sceneOf(mesh, linearField(mesh.points, gradient), curve);
    prepared.isosurfaces = std::move(surfaces);
  }
  double fieldAt(const Ray& ray, double distance) const {
    return 0.5 + dot(gradient, ray.origin + distance * ray.direction);
  }
};

RayColor of(const Color& color, double opacity) {
  return {opacity * color[0], opacity * color[1], opacity * color[2], opacity};
}

RayColor slab(double kappa, double length) { return of({0.8, 0.4, 0.2}, -std::expm1(-kappa * length)); }

/// The surfaces that the ray meets in the box between volume of constant extinction.
RayColor expected(const LinearScene& scene, double kappa, const Ray& ray) {
  const Stretch inside = throughBox(ray, Vec3(-1), Vec3(1));
  if (!(inside.length() > 0)) return {0, 0, 0, 0};
  struct Met {
    double at;
    RayColor color;
  };
  std::vector<Met> met;
  const double slope = dot(scene.gradient, ray.direction), atFirst = scene.fieldAt(ray, inside.first);
  for (const ShownIsosurface& s : scene.prepared.isosurfaces) {
    const double at = inside.first + (s.scalar - atFirst) / slope;
    if (at > inside.first && at < inside.last) met.push_back({at, of(s.color, s.opacity)});
  }
  std::sort(met.begin(), met.end(), [](const Met& a, const Met& b) { return a.at < b.at; });
  RayColor sum{0, 0, 0, 0};
  double begin = inside.first;
  for (const Met& m : met) {
    sum = over(over(sum, slab(kappa, m.at - begin)), m.color);
    begin = m.at;
  }
  return over(sum, slab(kappa, inside.last - begin));
}

/// Pixels whose ray leaves the box next to where it meets a surface may have it or not.
bool onTheRim(const LinearScene& scene, const Ray& ray) {
  const Stretch inside = throughBox(ray, Vec3(-1), Vec3(1));
  const auto& surfaces = scene.prepared.isosurfaces;
  return std::any_of(surfaces.begin(), surfaces.end(), [&](const ShownIsosurface& s) {
    return std::abs(scene.fieldAt(ray, inside.first) - s.scalar) < 1e-10 ||
           std::abs(scene.fieldAt(ray, inside.last) - s.scalar) < 1e-10;
  });
}

void expectPlanes(const std::vector<ShownIsosurface>& surfaces, double kappa) {
  for (const Vec3& gradient : {kGradient, -kGradient}) {
    const LinearScene scene(gradient, surfaces, constantCurve(kappa));
    std::size_t compared = 0;
    for (const View& view : obliqueViews(60)) {
      const auto pixels = referencePixels(scene.prepared, view);
      for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
          const Ray ray = rayOf(view, x, y);
          if (onTheRim(scene, ray)) continue;
          const RayColor want = expected(scene, kappa, ray);
          const RayColor& got = pixels[static_cast<std::size_t>(y * view.width + x)];
          for (std::size_t c = 0; c < 4; ++c) ASSERT_NEAR(got[c], want[c], kSurfaceBound) << x << ',' << y;
          compared += want[3] > 0 ? 1 : 0;
        }
    }
    EXPECT_GT(compared, 1000u);
  }
}

TEST(ReferenceIsosurfaces, OnePlaneOpaque) { expectPlanes({{0, 0.55, kOrange, 1}}, 0); }

TEST(ReferenceIsosurfaces, PlanesInAVolume) {
  expectPlanes({{0, 0.42, kBlue, 0.3}, {0, 0.5, kOrange, 0.5}, {0, 0.61, kBlue, 1}}, 0.9);
}

TEST(ReferenceIsosurfaces, AStackOfTranslucentOnesInAClearVolume) {
  constexpr double kOpacity = 0.2;
  std::vector<ShownIsosurface> stack;
  for (int n = 0; n < 12; ++n) stack.push_back({0, 0.4 + 0.017 * n, kOrange, kOpacity});
  const LinearScene scene(kGradient, stack, constantCurve(0));
  // Along the gradient from outside, through all of them.
  const View view = viewOf(true, -3.0 * normalize(kGradient), Vec3(0), 0.05, 4, 4);
  for (const RayColor& pixel : referencePixels(scene.prepared, view)) {
    EXPECT_NEAR(pixel[3], 1 - std::pow(1 - kOpacity, 12), 1e-14);
    EXPECT_NEAR(pixel[0], pixel[3], 1e-14);
  }
}

CellSegment segment(double entry, double exit, double from, double to) { return {entry, exit, from, to, 0}; }

// A surface at the value that two cells share at their face, from both sides; at a value that is only touched.
TEST(ReferenceIsosurfaces, AFacesValueIsCrossedOnce) {
  const ExtinctionCurve curve = constantCurve(0);
  const std::vector<ShownIsosurface> surfaces{{0, 0.5, kOrange, 0.25}};
  const auto alpha = [&](const std::vector<CellSegment>& ray) {
    const double all = rayColor({curve, surfaces}, ray)[3];
    EXPECT_EQ(all, rayIsosurfaces({curve, surfaces}, ray)[3]);
    return all;
  };
  EXPECT_EQ(alpha({segment(0, 1, 0.2, 0.5), segment(1, 2, 0.5, 0.8)}), 0.25);
  EXPECT_EQ(alpha({segment(0, 1, 0.8, 0.5), segment(1, 2, 0.5, 0.2)}), 0.25);
  EXPECT_EQ(alpha({segment(0, 1, 0.2, 0.5), segment(1, 2, 0.5, 0.5), segment(2, 3, 0.5, 0.8)}), 0.25);
  EXPECT_EQ(alpha({segment(0, 1, 0.8, 0.5), segment(1, 2, 0.5, 0.8)}), 0) << "touched from above";
  EXPECT_EQ(alpha({segment(0, 1, 0.2, 0.5), segment(1, 2, 0.5, 0.2)}), 1 - 0.75 * 0.75) << "reached from below";
  EXPECT_EQ(alpha({segment(0, 1, 0.5, 0.5)}), 0) << "all of one value";
}

// Where rounding moves the beginning of a segment, the ray goes on from the scalar that it has reached.
TEST(ReferenceIsosurfaces, RoundingBetweenCellsNeitherMissesNorDoublesASurface) {
  const ExtinctionCurve curve = constantCurve(0);
  const std::vector<ShownIsosurface> surfaces{{0, 0.5, kOrange, 0.25}};
  for (const double off : {-1e-16, 0.0, 1e-16})
    for (const double end : {0.2, 0.8})
      EXPECT_EQ(rayColor({curve, surfaces}, std::vector{segment(0, 1, 1 - end, 0.5), segment(1, 2, 0.5 + off, end)})[3],
                0.25)
          << off << " to " << end;
  // A jump, as between meshes that only touch, is none.
  EXPECT_EQ(rayColor({curve, surfaces}, std::vector{segment(0, 1, 0.1, 0.4), segment(1, 2, 0.6, 0.9)})[3], 0);
}

}  // namespace
}  // namespace havs::test
