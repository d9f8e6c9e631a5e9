// Rays through meshes with no closed form: against quadrature of the definition, and against refined meshes.
#include <gtest/gtest.h>

#include <random>

#include "transfer/transfer_function.h"
#include "unit/gauss_kronrod.h"
#include "unit/reference/rays.h"

namespace havs::test {
namespace {

std::vector<double> randomScalars(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<double> scalars(count);
  for (double& s : scalars) s = random() / 4294967295.0;
  return scalars;
}

ExtinctionCurve presetCurve(const std::string& name) { return makeCurve(loadTransferFunction(name), {}); }

/// Light gathered so far by the definition: each smooth stretch of c kappa exp(-depth) by adaptive quadrature.
class Quadrature {
 public:
  explicit Quadrature(const ExtinctionCurve& curve) : curve_(curve) {}

  /// A stretch on which the scalar is linear.
  void add(double from, double to, double length) {
    std::vector<double> cuts{0, 1};
    for (const auto& knot : curve_.knots) {
      const double t = (knot.s - from) / (to - from);
      if (t > 0 && t < 1) cuts.push_back(t);
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 1; i < cuts.size(); ++i) addPiece(from, to, length, cuts[i - 1], cuts[i]);
  }
  RayColor color() const {
    RayColor result{0, 0, 0, static_cast<double>(-std::expm1(-depth_))};
    for (std::size_t c = 0; c < 3; ++c) result[c] = static_cast<double>(color_[c]);
    return result;
  }

 private:
  void addPiece(double from, double to, double length, double first, double last) {
    const auto sample = [&](double share) { return curve_.at(from + (to - from) * std::lerp(first, last, share)); };
    const auto third = sample(1.0 / 3), second = sample(2.0 / 3);  // clear of steps at the ends
    const auto linear = [](double at13, double at23, long double t) { return at13 + (at23 - at13) * (3 * t - 1); };
    const long double stretch = (static_cast<long double>(last) - first) * length;
    const auto kappa = [&](long double t) { return linear(third.kappa, second.kappa, t); };
    for (std::size_t c = 0; c < 3; ++c) {
      const auto light = [&](long double t) {
        return stretch * kappa(t) * linear(third.color[c], second.color[c], t) *
               std::exp(-depth_ - stretch * t * (kappa(0) + kappa(t)) / 2);
      };
      color_[c] += integrate(light, 0, 1, 4);
    }
    depth_ += stretch * kappa(0.5L);
  }

  const ExtinctionCurve& curve_;
  std::array<long double, 3> color_{};
  long double depth_ = 0;
};

TEST(ReferenceWholeRays, AgainstAdaptiveQuadrature) {
  const TetMesh mesh = box(4, Cut::five, 0.25, 11);
  for (const char* name : {"rainbow", "viridis", "three-peaks"}) {
    const PreparedScene scene = sceneOf(mesh, randomScalars(mesh.points.size(), 5), presetCurve(name));
    for (const View& view : obliqueViews(8)) {
      const Deviation d = deviation(scene, view, [&](int x, int y) {
        const Ray ray = rayOf(view, x, y);
        Quadrature expected(scene.curve);
        for (const Stretch& s : clipCells(mesh, ray)) {
          auto scalar = [&](double t) { return scalarIn(mesh, s.cell, scene.scalars, ray.origin + t * ray.direction); };
          expected.add(scalar(s.first), scalar(s.last), s.length());
        }
        return expected.color();
      });
      EXPECT_LE(d.most, 1e-11) << name << ' ' << d;  // roundings of the ends, 1e-14, times slopes of up to 1e3
      EXPECT_GT(d.seen, 20u);
    }
  }
}

/// Each cell cut in four at its centroid, which takes the mean of the scalars.
TetMesh cutAtCentroids(const TetMesh& mesh, std::vector<double>& scalars) {
  TetMesh fine;
  fine.points = mesh.points;
  for (const Tetrahedron& cell : mesh.tetrahedra) {
    const auto centre = static_cast<Index>(fine.points.size());
    Vec3 point{0};
    double scalar = 0;
    for (const Index p : cell) {
      point += 0.25 * mesh.points[p];
      scalar += 0.25 * scalars[p];
    }
    fine.points.push_back(point);
    scalars.push_back(scalar);
    for (std::size_t i = 0; i < 4; ++i) {
      Tetrahedron part = cell;
      part[i] = centre;
      fine.tetrahedra.push_back(part);
    }
  }
  return fine;
}

TEST(ReferenceWholeRays, RefinementOfLinearCellsChangesNothing) {
  for (const TetMesh& mesh : {box(4, Cut::six, 0.25), oGrid(2, 9, 2), boxWithHole(3)})
    for (const char* name : {"viridis", "three-peaks"}) {
      std::vector<double> scalars = randomScalars(mesh.points.size(), 6);
      const ExtinctionCurve curve = presetCurve(name);
      const PreparedScene coarse = sceneOf(mesh, scalars, curve);
      const TetMesh once = cutAtCentroids(mesh, scalars);
      const TetMesh twice = cutAtCentroids(once, scalars);
      const PreparedScene fine = sceneOf(twice, scalars, curve);
      for (const View& view : obliqueViews(50)) {
        const auto expected = referencePixels(coarse, view);
        const Deviation d =
            deviation(fine, view, [&](int x, int y) { return expected[static_cast<std::size_t>(y * view.width + x)]; });
        EXPECT_LE(d.most, 1e-11) << name << ' ' << d;
        EXPECT_GT(d.seen, 400u);
      }
    }
}

TEST(ReferenceRenderer, RoundsToFloatOnceAndTellsItsProgress) {
  const TetMesh mesh = ball(5);
  const PreparedScene scene = sceneOf(mesh, randomScalars(mesh.points.size(), 7), presetCurve("viridis"));
  const View view = viewOf(false, {2.1, 1.7, 3.2}, {0, 0, 0}, 0.3, 97, 61);
  StageTimes stages;
  double last = 0;
  const Drawing drawing = makeReferenceRenderer(scene)->draw(view, stages, [&](std::string_view, double fraction) {
    EXPECT_GT(fraction, last);
    last = fraction;
  });
  EXPECT_EQ(last, 1.0);
  EXPECT_GT(stages.median("draw"), 0);
  EXPECT_FALSE(drawing.certificate.has_value());
  const auto pixels = referencePixels(scene, view);
  ASSERT_EQ(drawing.image.width, 97);
  ASSERT_EQ(drawing.image.height, 61);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    for (std::size_t c = 0; c < 4; ++c) ASSERT_EQ(drawing.image.rgba[4 * i + c], static_cast<float>(pixels[i][c]));
}

}  // namespace
}  // namespace havs::test
