// Opacity from 0 to 1: the steep, the all but opaque, and surfaces.
#include "hard/boxes.h"

namespace havs::test {
namespace {

using Segments = HardPictureTest;
using Points = SegmentTruth::Points;

constexpr double kRounded = 1e-7;  // the reference is rounded to float once
// Extinction between control points is resampled to within 1e-4 of itself (docs/02-method.md): of a depth x the colour
// then changes by at most 1e-4 x exp(-x) <= 1e-4 / e.
constexpr double kResampled = 4e-5;

class Opacities : public Segments {
 protected:
  HardPicture expectDrawn(const Points& points, double unitLength, const SlantedBox& box, double truthBound,
                          const HardBounds& bounds = {}) {
    Scene scene = hardScene();
    scene.transferFunction = transferFile(transferOf(points, "per_unit", unitLength));
    HardPicture picture = expectEveryWay(scene, box.mesh(), bounds);
    expectAtMost("reference to quadrature", worstChord(picture, SegmentTruth(points, true, unitLength), box),
                 truthBound);
    return picture;
  }
  static std::size_t pixelsOfOpacity(const Image& image, float opacity) {
    std::size_t count = 0;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) count += image.rgba[i] >= opacity;
    return count;
  }
};

TEST_F(Opacities, ExerciseOfThePreIntegrationSeed) {
  tell({"Segments",
        "opacity 1 from 128 to 192 of 255: extinction is infinite; a table smears the step up to the surface over its "
        "entries, and compositing with pow(1 - opacity, d) divides by 0",
        "opacity 1 is a surface: the segment ends where it first meets it, and what lies before is integrated"});
  constexpr double kLast = 255;
  const Points exercise{{0, 1, 0.384313, 0.384313, 0},
                        {64 / kLast, 1, 0.384313, 0.384313, 0},
                        {128 / kLast, 1, 1, 0.705882, 1},
                        {192 / kLast, 1, 1, 1, 1},
                        {1, 1, 1, 1, 0}};
  const HardPicture picture = expectDrawn(exercise, 0.3, {}, kResampled);
  EXPECT_GT(pixelsOfOpacity(picture.truth, 1), 300u);
}

TEST_F(Opacities, OneAtOnePoint) {
  tell({"Segments", "opacity touches 1 at a single scalar: samples and table entries next to it never see it",
        "the interval of opacity 1 may be a point: a surface of one scalar, an isosurface"});
  const Points peak{{0, 0.2, 0.2, 1, 0}, {0.5, 1, 0.6, 0.1, 1}, {1, 0.2, 1, 0.2, 0}};
  const HardPicture picture = expectDrawn(peak, 1, {}, kResampled);
  EXPECT_GT(pixelsOfOpacity(picture.truth, 1), 300u);
  expectDrawn(peak, 1, {0.5, 0}, kRounded);  // the field stays there: all corners and all between them
}

TEST_F(Opacities, OneAtTheEndOfTheDomain) {
  tell({"Segments",
        "a surface of one scalar, the last: before this case it had the colour of the other side of the step there, on "
        "every device; and OpenGL keeps 1 at the boundary as 0.99999994, as a fragment's kind takes two bits, which is "
        "no surface",
        "a surface of one scalar has its own colour; 0.99999994 stands for 1 and is read as 1"});
  const Points end{{0, 0, 0, 1, 0}, {1, 0, 0, 1, 0}, {1, 1, 0.5, 0, 1}};
  expectDrawn(end, 1, {1, 0}, kRounded);
}

TEST_F(Opacities, OneAtOnePointWithAStepOnEitherSide) {
  tell({"Segments",
        "before this case the colour of a surface of one scalar was read from the curve, which at a step there holds "
        "the colour of the upper side, opaque or not",
        "with such an interval goes its own colour, that of the side that is opaque"});
  expectDrawn({{0, 0, 0, 1, 0}, {0.5, 1, 0.5, 0, 1}, {0.5, 0, 1, 0, 0.2}, {1, 0, 1, 1, 0}}, 1, {}, kResampled);
  expectDrawn({{0, 0, 0, 1, 0}, {0.5, 0, 1, 0, 0.2}, {0.5, 1, 0.5, 0, 1}, {1, 0, 1, 1, 0}}, 1, {}, kResampled);
}

TEST_F(Opacities, OneOverAPlateauBetweenSteps) {
  tell({"Segments", "a surface without a ramp before it: nothing, then opaque at once, from either side",
        "surfaces are found by where the scalar enters the interval; their colour is the inner one of the step"});
  const Points plateau{{0, 0, 0, 1, 0.1},   {0.4, 0, 0, 1, 0.1}, {0.4, 1, 0.2, 0, 1},
                       {0.6, 0.2, 1, 0, 1}, {0.6, 1, 1, 1, 0.2}, {1, 1, 1, 1, 0.2}};
  const HardPicture picture = expectDrawn(plateau, 1, {}, kRounded);
  EXPECT_GT(pixelsOfOpacity(picture.truth, 1), 300u);
}

TEST_F(Opacities, OneAtBothEndsOfTheDomain) {
  tell({"Segments", "rays enter the mesh within an opaque interval: the first segment has a surface and no length",
        "a segment that begins inside ends at its front, with the colour there"});
  const Points ends{{0, 1, 0, 0, 1},      {0.25, 0, 1, 0, 1}, {0.25, 1, 1, 1, 0.3},
                    {0.75, 1, 1, 1, 0.3}, {0.75, 0, 0, 1, 1}, {1, 1, 0, 1, 1}};
  const HardPicture picture = expectDrawn(ends, 1, {}, kRounded);
  EXPECT_GT(pixelsOfOpacity(picture.truth, 1), 300u);
}

TEST_F(Opacities, OneEverywhere) {
  tell({"Segments", "there is no volume left to integrate: only surfaces, where rays enter",
        "the part before the surface has length 0 and shows nothing; the surface has the scalar of the boundary"});
  const Points opaque{{0, 1, 0, 0.3, 1}, {1, 0, 1, 0.6, 1}};
  expectDrawn(opaque, 1, {}, kRounded);
  expectDrawn(opaque, 1, {0.37, 0}, kRounded);  // and a field of one value
}

TEST_F(Opacities, AllButOne) {
  tell({"Segments",
        "opacity 1 - 2^-24 is the last that is no surface: 16.6 depths a unit length, or, rounded to 1, "
        "an infinite one",
        "kept as an extinction, made in double"});
  constexpr double kAlmost = 1 - 0x1p-24;
  const Points almost{{0, 0.2, 0.3, 1, kAlmost}, {1, 1, 0.5, 0, kAlmost}};
  constexpr double kDepth = 16.64;  // 24 ln 2
  for (const double unitLength : {0.01, 1.0, 100.0})
    expectDrawn(almost, unitLength, {}, kRounded, boundsOfDensity(kDepth, unitLength));
}

TEST_F(Opacities, OneHundredMillionth) {
  tell({"Segments", "1 - 1e-8 is 1 in float: ln(1 - opacity) is 0, and the volume vanishes",
        "extinction by log1p in double; the unit length may be as short"});
  const Points faint{{0, 0.2, 0.3, 1, 1e-8}, {1, 1, 0.5, 0, 0.5e-8}};
  const HardPicture shallow = expectDrawn(faint, 1, {}, kRounded);
  const HardPicture deep = expectDrawn(faint, 1e-8, {}, kResampled);  // 1e8 unit lengths to a mesh unit
  EXPECT_GT(pixelsOfOpacity(deep.truth, 0.5F), 500u);
  const float most = *std::max_element(shallow.truth.rgba.begin(), shallow.truth.rgba.end());
  EXPECT_GT(most, 1e-8F);
  double worst = 0;
  for (std::size_t i = 0; i < shallow.truth.rgba.size(); ++i)
    worst = std::max(
        worst, std::abs(double{shallow.by("native k 6 topological").image.rgba[i]} - double{shallow.truth.rgba[i]}));
  expectAtMost("native at 1e-8, as a part of the greatest opacity", worst / most, 1e-5);
}

TEST_F(Opacities, NoneAnywhere) {
  tell({"Segments", "mean colours of nothing are 0 / 0",
        "a segment without extinction shows nothing, whatever its colour"});
  const HardPicture picture = expectDrawn({{0, 1, 1, 1, 0}, {1, 1, 1, 1, 0}}, 1, {}, 0);
  for (const HardDrawing& one : picture.drawings)
    expectAtMost("anything drawn", *std::max_element(one.drawing.image.rgba.begin(), one.drawing.image.rgba.end()), 0);
}

}  // namespace
}  // namespace havs::test
