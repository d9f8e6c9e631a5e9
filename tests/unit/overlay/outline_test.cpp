#include "overlay/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

#include "support/views.h"

namespace havs {
namespace {

const Vec3 kHalf{0.3, 0.6, 0.7};

/// Shares of the way from `start` along `direction` at which a line enters and leaves the box.
std::array<double, 2> wayInBox(const Vec3& start, const Vec3& direction) {
  double enter = -std::numeric_limits<double>::infinity(), leave = -enter;
  for (int i = 0; i < 3; ++i) {
    const double one = (-kHalf[i] - start[i]) / direction[i], other = (kHalf[i] - start[i]) / direction[i];
    enter = std::max(enter, std::min(one, other));
    leave = std::min(leave, std::max(one, other));
  }
  return {enter, leave};
}

/// The ray of a place in the picture.
void rayAt(const View& view, double x, double y, Vec3& start, Vec3& direction) {
  const Vec3 across =
      (2 * x / view.width - 1) * view.halfWidth * view.right + (1 - 2 * y / view.height) * view.halfHeight * view.up;
  start = view.orthographic ? view.center + across - 10.0 * view.forward : view.eye;
  direction = view.orthographic ? view.forward : view.forward + across;
}

/// In the picture a line is straight, and so is the edge; both have their ends in common.
void expectOnTheBox(const PictureLine& line, const View& view, bool front) {
  for (const double share : {0.02, 0.3, 0.71, 0.98}) {
    Vec3 start, direction;
    // Towards the picture's middle, which the box covers, by a hair: so the ray meets the box.
    const double x = line.fromX + share * (line.toX - line.fromX), y = line.fromY + share * (line.toY - line.fromY);
    const double inX = x + 1e-7 * (view.width / 2.0 - x), inY = y + 1e-7 * (view.height / 2.0 - y);
    rayAt(view, inX, inY, start, direction);
    const auto [enter, leave] = wayInBox(start, direction);
    const Vec3 place = start + (front ? enter : leave) * direction;
    int sides = 0;
    for (int i = 0; i < 3; ++i) sides += std::abs(std::abs(place[i]) - kHalf[i]) < 1e-4 ? 1 : 0;
    EXPECT_GE(sides, 2) << (front ? "front" : "back") << ' ' << place.x << ' ' << place.y << ' ' << place.z;
  }
}

TEST(OutlineLines, RaysEnterTheBoxAtTheFrontOnesAndLeaveItAtTheBackOnes) {
  LocalFrame frame;
  for (const Projection projection : {Projection::perspective, Projection::orthographic})
    for (const double azimuth : {10.0, 100.0, 215.0})
      for (const double elevation : {-40.0, 15.0}) {
        const View view = test::viewFrom(frame, azimuth, elevation, 100, projection);
        const OutlineLines lines = outlineLines(kHalf, view);
        EXPECT_EQ(lines.front.size() + lines.back.size(), 12u);
        EXPECT_GE(lines.front.size(), 7u) << "of two sides, or 9 of three";
        for (const PictureLine& line : lines.front) expectOnTheBox(line, view, true);
        for (const PictureLine& line : lines.back) expectOnTheBox(line, view, false);
      }
}

TEST(OutlineLines, AreAllBehindForAnEyeInTheBox) {
  LocalFrame frame;
  Camera camera;
  camera.eye = Vec3{0.1, 0.2, 0.1};
  camera.target = Vec3{0.05, 0.1, -0.6};
  const View view = makeView(camera, frame, 100, 100);
  const OutlineLines lines = outlineLines(kHalf, view);
  EXPECT_TRUE(lines.front.empty());
  EXPECT_EQ(lines.back.size(), 8u) << "four before the eye, four through the plane of the eye, four behind";
}

TEST(AddOutline, CompositesFrontOverAndBackUnderThePicture) {
  LocalFrame frame;
  const View view = test::viewFrom(frame, 30, 20, 64);
  const Outline outline{{1, 0.5, 0}, 2.5};
  const auto picture = [&](float alpha) {
    Image image{64, 64, {}};
    for (int i = 0; i < 64 * 64; ++i) image.rgba.insert(image.rgba.end(), {0, 0, alpha, alpha});
    addOutline(image, outline, kHalf, view);
    return image;
  };
  const Image clear = picture(0), half = picture(0.5f), opaque = picture(1);
  const OutlineLines lines = outlineLines(kHalf, view);
  const auto coverage = [](const std::vector<PictureLine>& some, double x, double y) {
    double most = 0;
    for (const PictureLine& line : some) most = std::max(most, lineCoverage(line.distance(x, y), 2.5));
    return most;
  };
  int over = 0, under = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const double front = coverage(lines.front, x + 0.5, y + 0.5), back = coverage(lines.back, x + 0.5, y + 0.5);
      over += front > 0 ? 1 : 0;
      under += back > 0 ? 1 : 0;
      const auto red = [&](const Image& image) { return static_cast<double>(image.pixel(x, y)[0]); };
      EXPECT_NEAR(red(clear), front + (1 - front) * back, 1e-6);
      EXPECT_NEAR(red(half), front + (1 - front) * 0.5 * back, 1e-6);
      EXPECT_NEAR(red(opaque), front, 1e-6) << "nothing is seen behind";
      EXPECT_NEAR(static_cast<double>(half.pixel(x, y)[3]), front + (1 - front) * (0.5 + 0.5 * back), 1e-6);
      EXPECT_NEAR(static_cast<double>(half.pixel(x, y)[2]), (1 - front) * 0.5, 1e-6);
    }
  EXPECT_GT(over, 300);
  EXPECT_GT(under, 50);
}

}  // namespace
}  // namespace havs
