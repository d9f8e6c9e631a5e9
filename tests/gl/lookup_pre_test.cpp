// The lookup `pre`: fragments that carry colour and extinction, against closed forms and other ways to the same
// picture.
#include <gtest/gtest.h>

#include "core/arithmetic.h"
#include "gl/drawing.h"
#include "render/plan.h"
#include "support/gl_test.h"
#include "support/replay.h"

namespace havs::test {
namespace {

constexpr int kBoxEdge = 4;
constexpr double kFloat = 2e-5;  // float scalars and distances, 60 segments composited in float
// Red and green have 16 bits: half a step, of opacity 1 at the most.
constexpr double kColor = kFloat + 0.5 / 65535;

class LookupPre : public FramebufferFetch {};

Scene smallScene(const std::string& transfer) {
  Scene scene;
  scene.transferFunction = transfer;
  scene.width = 120;
  scene.height = 90;
  scene.lookup = "pre";
  return scene;
}

// Colour and extinction linear in the scalar, the scalar linear in space: the whole ray is one linear piece.
constexpr const char* kRamp = R"({"version": 1, "opacity": "extinction", "unit_length": 1, "domain": [0, 1], "points": [
    {"scalar": 0, "color": [1, 0.2, 0], "opacity": 0.2}, {"scalar": 1, "color": [0.1, 0.3, 0.9], "opacity": 2.5}]})";

TEST_P(LookupPre, RampIsExactInEveryChannel) {
  using A = Arithmetic<DoubleLane>;
  const TransferFile transfer(kRamp);
  const Vec3 gradient(0.1, 0.3, 0.05);  // within [0, 1] on [-1, 1]^3
  for (auto projection : {Projection::perspective, Projection::orthographic})
    for (int k = 1; k <= 7; ++k) {
      Scene scene = smallScene(transfer.path());
      scene.camera.projection = projection;
      scene.k = k;
      TetMesh mesh = box(kBoxEdge, Cut::six, 0.2);
      auto values = linearField(mesh.points, gradient);
      const Drawing drawing = draw(*device_, scene, withPointField(std::move(mesh), std::move(values)));
      Image expected = drawing.image;
      for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x) {
          const Ray ray = rayOf(drawing, x, y);
          const auto [first, last] = throughBox(ray, Vec3(-1.0), Vec3(1.0));
          auto at = [&](double t) {
            const double s = 0.5 + dot(gradient, ray.origin + t * ray.direction);
            return A::Rgba(1 - 0.9 * s, 0.2 + 0.1 * s, 0.9 * s, 0.2 + 2.3 * s);
          };
          const A::Rgba c = last > first ? A::linearPiece(at(first), at(last), last - first) : A::Rgba(0, 0, 0, 0);
          float* const pixel = expected.pixel(x, y);
          pixel[0] = static_cast<float>(c.r);
          pixel[1] = static_cast<float>(c.g);
          pixel[2] = static_cast<float>(c.b);
          pixel[3] = static_cast<float>(c.a);
        }
      const Difference difference = between(drawing.image, expected, kColor, maskOf(drawing));
      EXPECT_LE(difference.maximum, kColor) << "k " << k << ": " << difference;
    }
}

// A curved transfer function: extinction is that of the vertices, linear between them, whatever the function does
// there.
TEST_P(LookupPre, ExtinctionOfTheVerticesAgainstTheReplayInDouble) {
  using A = Arithmetic<DoubleLane>;
  Scene scene = smallScene("three-peaks");
  TetMesh mesh = ball(8);
  auto values = smoothField(mesh.points);
  const Drawing drawing = draw(*device_, scene, withPointField(std::move(mesh), std::move(values)));
  const PreparedScene& prepared = drawing.prepared;
  std::vector<double> kappa;
  for (const double s : prepared.scalars) kappa.push_back(prepared.curve.at(s).kappa);
  FaceOrder order;
  sortMethod(scene.sort)
      .make({prepared.points, prepared.mesh.tetrahedra, &prepared.faces})
      ->sort(viewPointOf(drawing.view), order);
  const ReplayResult replayed = replay({prepared.points, &prepared.faces, order.faces, kappa, drawing.view}, scene.k,
                                       [](double front, double back, double length) {
                                         return Rgba{0, 0, 0, A::segmentWeights(front * length, back * length).alpha};
                                       });
  const auto mask = maskOf(drawing);
  std::size_t beyond = 0, compared = 0, seen = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i]) continue;
    ++compared;
    seen += replayed.image[i][3] > 0.1;
    beyond += std::abs(drawing.image.rgba[4 * i + 3] - replayed.image[i][3]) > 1e-4;
  }
  // Float interpolation on faces seen nearly edge on.
  EXPECT_LE(beyond, compared / 1000);
  EXPECT_GT(seen, compared / 20);
}

TEST_P(LookupPre, CellDataHasTheColourOfItsCell) {
  const TransferFile transfer(kRamp);
  TetMesh mesh = box(kBoxEdge);
  Field field{"c", 1, {}};
  for (const Tetrahedron& cell : mesh.tetrahedra) {
    double x = 0;
    for (Index p : cell) x += mesh.points[p].x;
    field.values.push_back(x < 0 ? 0.25 : 0.75);  // halves of the box
  }
  mesh.cellFields = {field};
  for (const char* lookup : {"pre", "post"}) {
    Scene scene = smallScene(transfer.path());
    scene.lookup = lookup;
    const Drawing drawing = draw(*device_, scene, mesh);
    const Difference difference = againstOpacity(drawing, [&](int x, int y) {
      const Ray ray = rayOf(drawing, x, y);
      const double low = lengthInBox(ray, {-1, -1, -1}, {0, 1, 1}), high = lengthInBox(ray, {0, -1, -1}, {1, 1, 1});
      return -std::expm1(-(0.2 + 2.3 * 0.25) * low - (0.2 + 2.3 * 0.75) * high);
    });
    EXPECT_LE(difference.maximum, kFloat) << lookup << ": " << difference;
  }
}

// Within a cell of constant colour all lookups agree; `post` takes colours from the same function.
TEST_P(LookupPre, CellDataLooksAsWithPostClassification) {
  TetMesh mesh = box(kBoxEdge, Cut::six, 0.2);
  Field field{"c", 1, {}};
  for (std::size_t c = 0; c < mesh.tetrahedra.size(); ++c) field.values.push_back(static_cast<double>(c % 9) / 8);
  mesh.cellFields = {field};
  const TransferFile transfer(kRamp);
  Scene scene = smallScene(transfer.path());
  const Image pre = draw(*device_, scene, mesh).image;
  scene.lookup = "post";
  EXPECT_LE(between(pre, draw(*device_, scene, mesh).image).maximum, kColor);
}

// Opacity 1 is no surface here, as fragments know no scalar, but the deepest fog that the transfer function has.
TEST_P(LookupPre, OpaqueIsDeepFog) {
  const TransferFile transfer(R"({"version": 1, "opacity": "per_unit", "unit_length": 4, "domain": [0, 1], "points": [
    {"scalar": 0, "color": [1, 1, 1], "opacity": 1}, {"scalar": 1, "color": [1, 1, 1], "opacity": 1}]})");
  TetMesh mesh = box(kBoxEdge, Cut::six, 0.2);
  auto values = constantField(mesh.points, 0.5);
  const Drawing drawing =
      draw(*device_, smallScene(transfer.path()), withPointField(std::move(mesh), std::move(values)));
  const Difference difference = againstOpacity(drawing, [&](int x, int y) {
    const double length = lengthInBox(rayOf(drawing, x, y), Vec3(-1.0), Vec3(1.0));
    return -std::expm1(-24 * std::log(2.0) / 4 * length);  // opacity 1 - 2^-24 of 4 units
  });
  EXPECT_LE(difference.maximum, 5 * kFloat) << difference;  // five times as dense as the others
}

TEST_P(LookupPre, OrderOfFragmentsIsThatOfScalars) {
  TetMesh mesh = stretchedLayers(8, 1.8);
  auto values = smoothField(mesh.points);
  mesh = withPointField(std::move(mesh), std::move(values));
  Scene scene = smallScene("viridis");
  scene.certificate = true;
  scene.sort = "centroid";
  for (int k : {1, 2, 7}) {
    scene.k = k;
    scene.lookup = "pre";
    const Drawing colors = draw(*device_, scene, mesh);
    scene.lookup = "post";
    const Drawing scalars = draw(*device_, scene, mesh);
    EXPECT_EQ(colors.certificate->count, scalars.certificate->count) << k;
    if (k == 1) {
      EXPECT_GT(colors.certificate->misordered, 0u);
    }
  }
}

TEST_P(LookupPre, HalfTargetsHoldItToTheirDigits) {
  const TransferFile transfer(kRamp);
  TetMesh mesh = box(kBoxEdge, Cut::six, 0.2);
  auto values = linearField(mesh.points, {0.1, 0.3, 0.05});
  mesh = withPointField(std::move(mesh), std::move(values));
  Scene scene = smallScene(transfer.path());
  const Drawing whole = draw(*device_, scene, mesh);
  scene.targetFormat = "16f";
  const Drawing half = draw(*device_, scene, mesh);
  // 8 bits of red and green; 72 segments, each rounding the opacity by 2^-12; ends of the ray off by 2^-11 radii.
  const double kappa = 2.5 * whole.prepared.frame.radius;
  EXPECT_LE(between(half.image, whole.image).maximum, 0.5 / 255 + 72.0 / 4096 + 2 * kappa / 2048);
  EXPECT_GT(between(half.image, whole.image).maximum, 1e-4);
  EXPECT_EQ(plan(scene, {}, capabilitiesOf(*device_)).bytesPerPixel, 8 * (1 + scene.k));
}

HAVS_FOR_EVERY_DEVICE(LookupPre);

}  // namespace
}  // namespace havs::test
