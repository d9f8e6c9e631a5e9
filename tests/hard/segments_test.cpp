// Segments whose integral is hard: both ends alike, no length, opaque, steps.
#include "hard/boxes.h"
#include "hard/hard_case.h"
#include "support/meshes.h"

namespace havs::test {
namespace {

using Segments = HardPictureTest;

const SegmentTruth::Points kRamp{{0, 0.2, 0.4, 0.8, 0.3}, {1, 0.9, 0.5, 0.1, 1.3}};

// The reference is rounded to float once; the chord's ends and the field there are good to some 1e-15.
constexpr double kTruth = 1e-7;

TEST_F(Segments, BothEndsTheSameScalar) {
  tell({"Segments", "differences of integral functions are divided by back - front: 0 / 0",
        "the weights of a piece are functions of optical depths, which have no such quotient"});
  const TetMesh mesh = box(3, Cut::five);
  Scene scene = hardScene();
  scene.transferFunction = transferFile(transferOf(kRamp));
  expectEveryWay(scene, withPoints(mesh, constantField(mesh.points, 0.37)));
}

TEST_F(Segments, FieldThatChangesByOneTenthToOneInAMillionMillion) {
  tell({"Segments", "the ends of all segments of the picture are equal but for some digits, or but for none in float",
        "as for equal ends; what float loses of a scalar moves the colour by as little"});
  Scene scene = hardScene(48);
  scene.transferFunction = transferFile(transferOf(kRamp));
  for (const double range : {1e-1, 1e-4, 1e-7, 1e-9, 1e-12}) {
    SCOPED_TRACE(range);
    const SlantedBox box{0.37, range};
    const HardPicture picture = expectEveryWay(scene, box.mesh());
    expectAtMost("reference to quadrature", worstChord(picture, SegmentTruth(kRamp, false), box), kTruth);
  }
}

TEST_F(Segments, RangeOfAFewDigitsStretchedOverTheDomain) {
  tell(
      {"Segments",
       "the field's range is 1e-12 of its values, or a single step of double, and is what the transfer function spans: "
       "in float its values are all the same",
       "scalars become parts of the domain in double, before anything is float"});
  Scene scene = hardScene(48);
  scene.transferFunction = transferFile(transferOf(kRamp, "extinction", 1, std::nullopt));
  for (const double range : {1e-12, 1e-15, 0x1p-53}) {
    SCOPED_TRACE(range);
    const HardPicture picture = expectEveryWay(scene, SlantedBox{0.75, range}.mesh());
    EXPECT_GT(picture.prepared.curve.domain[1], picture.prepared.curve.domain[0]);
    const auto [low, high] = std::minmax_element(picture.prepared.scalars.begin(), picture.prepared.scalars.end());
    expectAtMost("of the domain left unused", 1 - (*high - *low), 0);
  }
}

TEST_F(Segments, UnitLengthsFromAMillionthToATrillionTrillionMeshes) {
  tell({"Segments",
        "a mesh a million unit lengths deep is opaque at once, one of 1e-30 unit lengths shows 1e-30: 1 - exp(-x) "
        "is 0 there",
        "opacity is no difference from 1, and the picture is float: what is seen of a segment is exact as a part of "
        "itself"});
  Scene scene = hardScene(48);
  for (const double unit : {1e-6, 1e-3, 1e6, 1e12, 1e30}) {
    SCOPED_TRACE(unit);
    scene.transferFunction = transferFile(transferOf(kRamp, "extinction", unit));
    const SlantedBox box;
    const HardPicture picture = expectEveryWay(scene, box.mesh(), boundsOfDensity(1.3, unit));
    expectAtMost("reference to quadrature", worstChord(picture, SegmentTruth(kRamp, false, unit), box), kTruth);
    const double most = *std::max_element(picture.truth.rgba.begin(), picture.truth.rgba.end());
    EXPECT_GT(most, std::min(1 / unit, 0.5));
    for (const HardDrawing& one : picture.drawings)
      if (one.way.group == "native" && unit > 1) {
        // Distances are float: 6e-8 of the radius, beside segments of some 1e-2 where the mesh is thinnest seen; a
        // pixel's way as a whole is off by less than 1e-6 of the radius, 1e-4 of a chord of 1e-2.
        double worst = 0;
        for (std::size_t i = 3; i < picture.truth.rgba.size(); i += 4)
          worst = std::max(worst, std::abs(double{one.drawing.image.rgba[i]} - double{picture.truth.rgba[i]}));
        expectAtMost("native, as a part of the greatest opacity", worst / most, 1e-5);
      }
  }
}

TEST_F(Segments, StepsOfExtinctionAcrossCells) {
  tell({"Segments", "a table, or samples, smear a step of the transfer function over their spacing",
        "segments are cut at control points; two at one scalar end one piece and begin the next"});
  const SegmentTruth::Points steps{
      {0, 0, 1, 0, 2},   {0.3, 0, 0, 1, 1},  {0.3, 1, 0, 0, 9},    {0.5, 1, 0, 0, 9},       {0.5, 1, 1, 1, 0},
      {0.7, 1, 1, 1, 0}, {0.7, 0, 1, 1, 40}, {0.701, 0, 1, 1, 40}, {0.701, 0.5, 0.5, 0, 0}, {1, 0.5, 0.5, 0, 3}};
  Scene scene = hardScene();
  scene.transferFunction = transferFile(transferOf(steps));
  const SlantedBox box;
  const HardPicture picture = expectEveryWay(scene, box.mesh());
  expectAtMost("reference to quadrature", worstChord(picture, SegmentTruth(steps, false), box), kTruth);
}

TEST_F(Segments, FieldThatStaysOnAStep) {
  tell({"Segments",
        "on OpenGL, before this case, a field of one value came out of the interpolation a rounding lower at some "
        "pixels, on the other side of a step at that value",
        "on a step its upper side holds, everywhere; a face whose corners are alike has their scalar, bit for bit"});
  const SegmentTruth::Points step{{0, 0, 0, 1, 2}, {0.5, 0, 0, 1, 2}, {0.5, 1, 0.5, 0, 0.5}, {1, 1, 0.5, 0, 0.5}};
  Scene scene = hardScene();
  scene.transferFunction = transferFile(transferOf(step));
  const SlantedBox box{0.5, 0};
  const HardPicture picture = expectEveryWay(scene, box.mesh());
  expectAtMost("reference to quadrature", worstChord(picture, SegmentTruth(step, false), box), kTruth);
}

}  // namespace
}  // namespace havs::test
