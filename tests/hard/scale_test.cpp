// Units of length and of the field: from one end of double to the other.
#include "hard/like_plain.h"

namespace havs::test {
namespace {

using Scale = LikePlainTest;

constexpr const char* kGroup = "Scale and place";

Units lengths(double length) { return {.length = length}; }
Units scalars(double scalar, double offset = 0) { return {.scalar = scalar, .offset = offset}; }

TEST_F(Scale, PositionsFrom1em12To1e12) {
  tell({kGroup, "tolerances and epsilons in mesh units hold for one unit of length only",
        "positions go to a frame of radius 1 in double before anything else is made of them"});
  expectLikePlain(plainScene(), plainMesh(),
                  {lengths(1e-12), lengths(1e-6), lengths(1e-3), lengths(1e3), lengths(1e6), lengths(1e12)});
}

TEST_F(Scale, PositionsAtTheEndsOfDouble) {
  tell({kGroup, "squares of 1e-200 are 0 and of 1e200 infinite: lengths, volumes, normals are not numbers",
        "lengths are divided by the largest half side before they are squared, so that the frame is right up to "
        "1e300"});
  expectLikePlain(plainScene(), plainMesh(), {lengths(1e-150), lengths(1e150), lengths(1e-290), lengths(1e300)});
}

TEST_F(Scale, PowersOfTwoChangeNoBit) {
  tell({kGroup, "any constant in mesh units would show", "none is left: pictures are equal bit for bit"});
  expectLikePlain(plainScene(), plainMesh(), {lengths(0x1p-40), lengths(0x1p40), lengths(0x1p-500), lengths(0x1p500)},
                  {}, 0);
}

TEST_F(Scale, ScalarsFrom1em30To1e30) {
  tell({kGroup, "single precision ends at 1e-38 and 3e38, and tables of 8 bits of a raw value long before",
        "scalars become fractions of the domain in double; only these are rounded to float"});
  expectLikePlain(plainScene(), plainMesh(), {scalars(1e-30), scalars(1e30), scalars(1e30, 5e30)});
}

TEST_F(Scale, ScalarsAtTheEndsOfDouble) {
  tell({kGroup, "high - low of a domain from -1.7e308 to 1.7e308 is infinite, of 1e-300 times a fraction subnormal",
        "a domain wider than the largest double is halved before it is divided by"});
  Scene scene = plainScene();
  scene.domain = {-1, 1};
  const TetMesh mesh = mapped(
      plainMesh(), [](const Vec3& p) { return p; }, [](double v) { return 2 * v - 1; });
  expectLikePlain(scene, mesh, {scalars(1e-290), scalars(1e300), scalars(1.7e308)});
}

TEST_F(Scale, CellDataFrom1em30To1e30) {
  tell({kGroup, "cell data go their own way to the fragments, from a buffer",
        "they are fractions of the domain before they are uploaded"});
  expectLikePlain(plainScene(), withCellMeans(plainMesh()), {scalars(1e-30), scalars(1e30), lengths(1e-12)});
}

TEST_F(Scale, EverythingExtremeAtOnce) {
  tell({kGroup, "tiny cells with huge scalars far from the origin: products of the extremes leave double",
        "lengths and scalars are made of order 1 each by itself, before any product of both"});
  const Units tinyAndHuge{.length = 1e-12, .place = Vec3(3e-9, -2e-9, 1e-9), .scalar = 1e30, .offset = 5e31};
  const Units hugeAndTiny{.length = 1e12, .place = Vec3(-4e15, 1e15, 2e15), .scalar = 1e-30, .offset = -3e-29};
  expectLikePlain(plainScene(), plainMesh(), {tinyAndHuge, hugeAndTiny});
}

TEST_F(Scale, DefaultUnitLengthAndDomain) {
  tell({kGroup, "what a scene does not say is found from the mesh, at any size",
        "1/20 of the bounding diagonal and the field's range scale along"});
  Scene scene = plainScene();
  scene.unitLength.reset();
  scene.domain.reset();
  expectLikePlain(scene, plainMesh(), {{.length = 1e-150, .scalar = 1e30}, {.length = 1e150, .scalar = 1e-30}});
}

}  // namespace
}  // namespace havs::test
