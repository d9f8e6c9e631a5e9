// Optical depths against closed forms. Lengths of at most 3.5 add up without adding errors, since a cell begins where
// the last ended; their ends are rounded, times the slope of the face there (1 in 10 at least, of these directions).
// From the boundary rays are turned by 1e-12, over the same length and slope.
#include "light/mesh_tracer.h"

#include <gtest/gtest.h>

#include <random>

#include "unit/light/light_scene.h"

namespace havs::test {
namespace {

constexpr double kRounded = 5e-14;
constexpr double kTurned = 3.5 * 10 * LineFrame::kTurn;

/// `steepest`: of what is added up along the rays, per length.
void expectDepths(const LightScene& scene, const std::vector<Vec3>& directions,
                  const std::function<double(const Vec3&, const Vec3&)>& expected, double steepest = 1) {
  const Worst worst = worstDepth(scene, directions, expected);
  EXPECT_LE(worst.inside, steepest * kRounded);
  EXPECT_LE(worst.atBoundary, steepest * kTurned);
}

double inCube(const Vec3& p, const Vec3& d, double half) { return throughBox(p, d, Vec3(-half), Vec3(half)).length(); }

TEST(MeshTracer, LengthsInABoxFromEveryPointAlsoAlongItsEdges) {
  for (const Cut cut : {Cut::five, Cut::six})
    for (const double jitter : {0.0, 0.2}) {
      const LightScene scene = constantScene(box(5, cut, jitter), 1);
      expectDepths(scene, testDirections(60), [](auto& p, auto& d) { return inCube(p, d, 1); });
    }
}

TEST(MeshTracer, GoesOnBehindGapsAndTouchingParts) {
  for (const double gap : {0.0, 1e-15, 1e-12, 1e-7, 0.2}) {
    const LightScene scene = constantScene(twoBoxes(3, gap), 1);
    const auto expected = [=](const Vec3& p, const Vec3& d) {
      return throughBox(p, d, {-1, -1, -1}, {0, 1, 1}).length() +
             throughBox(p, d, {gap, -1, -1}, {1 + gap, 1, 1}).length();
    };
    // Not along the plane of the gap: there both boxes may or may not be met.
    std::vector<Vec3> directions = testDirections(60);
    std::erase_if(directions, [](const Vec3& d) { return d.x == 0; });
    SCOPED_TRACE(gap);
    expectDepths(scene, directions, expected);
  }
}

TEST(MeshTracer, GoesOnThroughHollowsAndHoles) {
  // Directions along the hollows' walls run in the boundary of what they are measured against.
  const LightScene shells = constantScene(nestedShells(2), 1);
  const auto inShells = [](const Vec3& p, const Vec3& d) {
    return inCube(p, d, 1) - inCube(p, d, 0.6) + inCube(p, d, 0.3);
  };
  expectDepths(shells, generalDirections(80), inShells);
  const LightScene hole = constantScene(boxWithHole(6), 1);
  const auto aroundHole = [](const Vec3& p, const Vec3& d) {
    return inCube(p, d, 1) - throughBox(p, d, Vec3(-1.0 / 3, -1.0 / 3, -1), Vec3(1.0 / 3, 1.0 / 3, 1)).length();
  };
  expectDepths(hole, generalDirections(80), aroundHole);
}

TEST(MeshTracer, LinearExtinctionOfALinearField) {
  const Vec3 g{0.2, -0.13, 0.16};
  TetMesh mesh = box(4, Cut::six, 0.25);
  std::vector<double> scalars = linearField(mesh.points, g);
  const LightScene scene(std::move(mesh), std::move(scalars), curveOf({{0, 0.5}, {1, 7.5}}));
  const auto expected = [&](const Vec3& p, const Vec3& d) {
    const double l = inCube(p, d, 1);
    return l * (0.5 + 7 * (0.5 + dot(g, p) + 0.5 * l * dot(g, d)));
  };
  expectDepths(scene, testDirections(60), expected, 7.5);
}

/// Against every cell clipped for itself; the curve's integral over each by pieces of the definition.
double clippedDepth(const LightScene& scene, const Vec3& p, const Vec3& d, double from = 0, double to = 1e300) {
  double sum = 0;
  for (const CellStretch& stretch : clipCells(scene, p, d)) {
    const auto [first, last] = stretch.range;
    const double a = std::clamp(first, from, to), b = std::clamp(last, from, to);
    if (!(a < b)) continue;
    const auto scalar = [&](double t) {
      return last > first ? std::lerp(stretch.sFirst, stretch.sLast, (t - first) / (last - first)) : stretch.sFirst;
    };
    // Between knots the mean of both ends is exact; so the stretch is cut where the scalar is a knot's.
    std::vector<double> cuts{a, b};
    for (const auto& knot : scene.curve.knots) {
      const double t = first + (knot.s - stretch.sFirst) / (stretch.sLast - stretch.sFirst) * (last - first);
      if (t > a && t < b) cuts.push_back(t);
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const double middle = 0.5 * (cuts[i] + cuts[i + 1]);  // kappa is linear, so its mean is that of the middle
      sum += (cuts[i + 1] - cuts[i]) * scene.curve.at(scalar(middle)).kappa;
    }
  }
  return sum;
}

std::vector<double> randomValues(std::size_t count) {
  std::mt19937 random(7);
  std::vector<double> values(count);
  for (double& v : values) v = random() / 4294967295.0;
  return values;
}

const ExtinctionCurve& peaks() {
  static const ExtinctionCurve curve =
      curveOf({{0, 1}, {0.2, 0}, {0.3, 6}, {0.3, 2}, {0.31, 2}, {0.55, 9}, {0.7, 0}, {0.7, 4}, {1, 0.5}});
  return curve;
}

TEST(MeshTracer, AnyFieldUnderACurveOfStepsAndPeaks) {
  for (const bool cellData : {false, true}) {
    TetMesh mesh = merged(box(3, Cut::six, 0.25), TetMesh());
    const std::size_t count = cellData ? mesh.tetrahedra.size() : mesh.points.size();
    const LightScene scene(std::move(mesh), randomValues(count), peaks(), cellData);
    SCOPED_TRACE(cellData);
    expectDepths(
        scene, generalDirections(40), [&](auto& p, auto& d) { return clippedDepth(scene, p, d); },
        9 * 10);  // kappa may jump by 9 at each of about ten faces
  }
}

TEST(MeshTracer, FromADistanceToAnother) {
  TetMesh mesh = twoBoxes(2, 0.3);
  const std::size_t count = mesh.points.size();
  const LightScene scene(std::move(mesh), randomValues(count), peaks());
  const MeshTracer tracer(scene.medium());
  PointRays rays(tracer);
  const std::vector<std::array<double, 2>> ranges{{0, 0.1}, {0.1, 0.45}, {0.45, 1.3}, {1.3, 9}, {0, 0}, {0.2, 0.1}};
  for (std::size_t p = 0; p < count; p += 7) {
    rays.startAt(static_cast<Index>(p));
    for (const Vec3& d : generalDirections(20))
      for (const auto& [from, to] : ranges) {
        const double expected = from < to ? clippedDepth(scene, scene.mesh.points[p], d, from, to) : 0;
        EXPECT_NEAR(rays.opticalDepth(d, from, to), expected, 9 * kTurned);
        EXPECT_NEAR(rays.transmittance(d, from, to), std::exp(-expected), 9 * kTurned);
      }
  }
}

TEST(MeshTracer, MomentOfABall) {
  TetMesh mesh = twoBoxes(2, 0.3);
  const std::size_t count = mesh.points.size();
  const LightScene scene(std::move(mesh), randomValues(count), peaks());
  const MeshTracer tracer(scene.medium());
  PointRays rays(tracer);
  constexpr double kRadius = 0.8;
  for (std::size_t p = 0; p < count; p += 11) {
    rays.startAt(static_cast<Index>(p));
    for (const Vec3& d : fibonacciDirections(10)) {
      // The integral of 2 r (depth beyond r) over r is that of kappa r^2: by parts.
      double moment = 0;
      constexpr int kSteps = 4000;
      for (int i = 0; i < kSteps; ++i) {
        const double r = (i + 0.5) * kRadius / kSteps;
        moment += 2 * r * rays.opticalDepth(d, r, kRadius) * kRadius / kSteps;
      }
      const PointRays::BallRay ray = rays.ballRay(d, kRadius);
      EXPECT_NEAR(ray.moment, moment, 1e-5);  // the midpoint rule: kappa' h^2 / 24, and steps h kappa
      EXPECT_EQ(ray.opticalDepth, rays.opticalDepth(d, 0, kRadius));
    }
  }
}

TEST(MeshTracer, OpaqueSurfacesLetNothingThrough) {
  TetMesh mesh = box(4, Cut::six, 0.2);
  std::vector<double> scalars = linearField(mesh.points, {0.5, 0, 0});  // s = (1 + x) / 2
  ExtinctionCurve curve = constantKappa(0.7);
  curve.opaque = {{0.9, 0.95}};  // 0.8 <= x <= 0.9
  const LightScene scene(std::move(mesh), std::move(scalars), curve);
  const MeshTracer tracer(scene.medium());
  PointRays rays(tracer);
  for (std::size_t p = 0; p < scene.mesh.points.size(); ++p) {
    rays.startAt(static_cast<Index>(p));
    const Vec3& point = scene.mesh.points[p];
    for (const Vec3& d : generalDirections(30)) {
      const double end = point.x + d.x * inCube(point, d, 1);
      const double low = std::min(point.x, end), high = std::max(point.x, end);
      const bool blocked = inCube(point, d, 1) > 0 && low <= 0.9 && high >= 0.8;
      EXPECT_NEAR(rays.transmittance(d), blocked ? 0 : std::exp(-0.7 * inCube(point, d, 1)), kTurned);
      EXPECT_EQ(std::isinf(rays.opticalDepth(d)), blocked);
    }
  }
}

// Layers of which each is 30 times as thick as the last, down to 1e-7: cells of aspect ratios to 1e7, bent.
TEST(MeshTracer, Slivers) {
  const LightScene scene = constantScene(stretchedLayers(6, 30.0), 1);
  const auto expected = [&](const Vec3& p, const Vec3& d) {
    double sum = 0;
    for (const CellStretch& s : clipCells(scene, p, d)) sum += s.range.length();
    return sum;
  };
  expectDepths(scene, generalDirections(8), expected, 50);  // rays graze the bent floor, at 1 in 500
}

// Inner points moved into the planes of faces: cells of volume 0 beside others that are whole.
TEST(MeshTracer, FlatCells) {
  TetMesh mesh = box(4, Cut::six);
  for (Vec3& p : mesh.points)
    if (std::abs(p.x) < 0.9 && std::abs(p.y) < 0.9 && std::abs(p.z) < 0.9) p.x += 0.5;  // a whole cube edge
  std::size_t flat = 0;
  for (std::size_t c = 0; c < mesh.tetrahedra.size(); ++c) flat += volume(mesh, c) == 0;
  ASSERT_GT(flat, 0u);
  for (Vec3& p : mesh.points) p.x = std::min(p.x, 1.0);
  const LightScene scene = constantScene(std::move(mesh), 1);
  const MeshTracer tracer(scene.medium());
  PointRays rays(tracer);
  for (std::size_t p = 0; p < scene.mesh.points.size(); ++p) {
    rays.startAt(static_cast<Index>(p));
    for (const Vec3& d : testDirections(40)) {
      const double depth = rays.opticalDepth(d);
      EXPECT_TRUE(std::isfinite(depth));
      EXPECT_GE(depth, 0);
    }
  }
}

}  // namespace
}  // namespace havs::test
