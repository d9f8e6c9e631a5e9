// Control points: many, close, repeated, out of order, alone.
#include <random>

#include "hard/boxes.h"

namespace havs::test {
namespace {

using Segments = HardPictureTest;
using Points = SegmentTruth::Points;

constexpr double kRounded = 1e-7;  // the reference is rounded to float once

/// Points at `scalars` of seeded colours, and opacities up to `most`.
Points randomPoints(const std::vector<double>& scalars, double most) {
  std::mt19937 random(11);
  const auto unit = [&] { return random() / 4294967295.0; };
  Points points;
  for (const double s : scalars) points.push_back({s, unit(), unit(), unit(), most * unit()});
  return points;
}

TEST_F(Segments, TenThousandControlPoints) {
  tell({"Segments",
        "a segment crosses thousands of control points: a table of 128 entries has no room for them, and sums of "
        "thousands of parts lose digits in float",
        "`exact` goes from point to point, found by a guide over the scalar; its sums keep what roundings leave out"});
  constexpr int kCount = 10000;
  std::vector<double> scalars;
  for (int i = 0; i < kCount; ++i) scalars.push_back(i / double{kCount - 1});
  const Points points = randomPoints(scalars, 2);
  Scene scene = hardScene(24);
  scene.transferFunction = transferFile(transferOf(points));
  const SlantedBox box{0, 1, 2};
  const HardPicture picture = expectEveryWay(scene, box.mesh());
  ASSERT_EQ(picture.prepared.curve.knots.size(), points.size());
  // A ray on which the scalar stays within a few pieces sees little; the middle one crosses half of them.
  expectAtMost("reference to quadrature", worstChord(picture, SegmentTruth(points, false), box), kRounded);
}

TEST_F(Segments, ControlPointsAStepOfDoubleApart) {
  tell({"Segments",
        "neighbours in double are one number in float: pieces of no width, or, where a knot's float lies beyond the "
        "scalar, the wrong piece",
        "a knot's place is kept as head and tail; knots that even these cannot tell apart are a step"});
  std::vector<double> scalars{0};
  for (const double middle : {0.25, 0.5, 0.75})
    for (double s = middle, i = 0; i < 4; ++i, s = std::nextafter(s, 1)) scalars.push_back(s);
  for (const double gap : {1e-15, 1e-12, 1e-9, 1e-7}) scalars.push_back(0.8 + gap);
  scalars.push_back(1);
  const Points points = randomPoints(scalars, 3);
  Scene scene = hardScene(48);
  scene.transferFunction = transferFile(transferOf(points));
  const SlantedBox box;
  const HardPicture picture = expectEveryWay(scene, box.mesh());
  expectAtMost("reference to quadrature", worstChord(picture, SegmentTruth(points, false), box), kRounded);
}

TEST_F(Segments, ControlPointGivenTwiceIsAStep) {
  tell({"Segments", "a piece of no width has no slope: 0 / 0",
        "two points at one scalar end one piece and begin the next; at the ends of the domain, too, the upper one "
        "holds"});
  const Points points{{0, 1, 0, 0, 3},   {0, 0, 1, 0, 1}, {0.5, 0, 1, 0, 1},
                      {0.5, 0, 0, 1, 4}, {1, 0, 0, 1, 4}, {1, 1, 1, 0, 0.2}};
  Scene scene = hardScene(48);
  scene.transferFunction = transferFile(transferOf(points));
  for (const SlantedBox& box : {SlantedBox{}, SlantedBox{0, 0}, SlantedBox{0.5, 0}, SlantedBox{1, 0}}) {
    SCOPED_TRACE(box.low);
    const HardPicture picture = expectEveryWay(scene, box.mesh());
    expectAtMost("reference to quadrature", worstChord(picture, SegmentTruth(points, false), box), kRounded);
  }
}

TEST_F(Segments, SingleControlPoint) {
  tell({"Segments", "there is no second point to interpolate to, and no piece to look a scalar up in",
        "a function is constant beyond its first and last point: one point is one colour and opacity everywhere"});
  const SlantedBox box;
  for (const double at : {0.0, 0.3, 1.0}) {
    const Points point{{at, 0.9, 0.6, 0.2, 0.8}};
    Scene scene = hardScene(48);
    scene.transferFunction = transferFile(transferOf(point));
    const HardPicture picture = expectEveryWay(scene, box.mesh());
    double worst = 0;
    for (int i = 0; i < picture.view.width * picture.view.height; ++i) {
      const Chord chord = chordOf(picture, i % picture.view.width, i / picture.view.width);
      const double alpha = -std::expm1(-0.8 * length(chord.exit - chord.entry));
      const float* p = &picture.truth.rgba[4 * static_cast<std::size_t>(i)];
      worst = std::max(worst, distance({p[0], p[1], p[2], p[3]}, {0.9 * alpha, 0.6 * alpha, 0.2 * alpha, alpha}));
    }
    expectAtMost("reference to closed form", worst, kRounded);
  }
}

TEST_F(Segments, ControlPointsOutOfOrder) {
  tell({"Segments", "a search among points that do not ascend finds some piece or none: a wrong picture without a word",
        "refused, with the number of the point; nothing is sorted silently, as two orders may be meant"});
  Scene scene = hardScene();
  scene.transferFunction =
      transferFile(transferOf({{0, 1, 0, 0, 1}, {0.6, 0, 1, 0, 1}, {0.4, 0, 0, 1, 1}, {1, 1, 1, 1, 1}}));
  expectRefused(scene, SlantedBox{}.mesh(), "point 3: scalar 0.4 comes after 0.6");
}

TEST_F(Segments, ControlPointGivenThreeTimes) {
  tell({"Segments", "of three points at one scalar the middle one is nowhere: two programs may keep different ones",
        "refused, with the number of the point and what two of them mean"});
  Scene scene = hardScene();
  scene.transferFunction = transferFile(
      transferOf({{0, 1, 0, 0, 1}, {0.5, 0, 1, 0, 1}, {0.5, 1, 1, 0, 1}, {0.5, 0, 0, 1, 1}, {1, 1, 1, 1, 1}}));
  expectRefused(scene, SlantedBox{}.mesh(), "point 4: scalar 0.5 is given a third time");
}

TEST_F(Segments, NoControlPoint) {
  tell({"Segments", "a transfer function of no points says nothing of any scalar", "refused; one point is enough"});
  Scene scene = hardScene();
  scene.transferFunction = transferFile(transferOf({}));
  expectRefused(scene, SlantedBox{}.mesh(), "at least one control point");
}

}  // namespace
}  // namespace havs::test
