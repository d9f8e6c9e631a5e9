// Units of length and of the field: from one end of double to the other.
#include <fmt/format.h>

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

TEST_F(Scale, OpacityUnitFarFromTheMeshs) {
  tell({kGroup, "a unit length of 1e-30 of the mesh makes extinctions beyond single precision, one of 1e30 nothing",
        "what is solid for any number is drawn solid, what shows nothing shows nothing"});
  Scene scene = plainScene();
  // At 1e-3 a radius has the optical depth 4e3, so that OpenGL's distances, good to 1.5e-7, leave colours good to some
  // 1e-4 where a segment ends within it. At 1e-12 and below nothing is seen of a segment but its front.
  HardBounds bounds;
  for (const double unit : {1e-3, 1e-12, 1e-30, 1e30, 1e150}) {
    SCOPED_TRACE(unit);
    scene.unitLength = unit;
    bounds.p999 = unit == 1e-3 ? 1e-4 : HardBounds{}.p999;
    expectEveryWay(scene, plainMesh(), bounds);
  }
}

TEST_F(Scale, DefaultUnitLengthAndDomain) {
  tell({kGroup, "what a scene does not say is found from the mesh, at any size",
        "1/20 of the bounding diagonal and the field's range scale along"});
  Scene scene = plainScene();
  scene.unitLength.reset();
  scene.domain.reset();
  expectLikePlain(scene, plainMesh(), {{.length = 1e-150, .scalar = 1e30}, {.length = 1e150, .scalar = 1e-30}});
}

TEST_F(Scale, TransferFunctionInDataUnits) {
  tell({kGroup, "control points in the data's unit, some 1e30 apart or 1.7e308",
        "they become fractions of the domain as the scalars do"});
  const auto transfer = [](const Units& units) {
    std::string text = R"({"version": 1, "opacity": "per_unit", "scale": "data", "points": [)";
    for (const auto& [scalar, red, opacity] : {std::array{-1.0, 0.1, 0.0}, std::array{0.125, 0.9, 0.5},
                                               std::array{0.25, 0.4, 0.1}, std::array{1.0, 0.2, 0.9}})
      text += fmt::format(R"({}{{"scalar": {}, "color": [{}, 0.3, 0.6], "opacity": {}}})",
                          text.back() == '[' ? "" : ", ", units.value(scalar), red, opacity);
    return transferFile(text + "]}");
  };
  Scene scene = plainScene();
  scene.domain = {-1, 1};
  const TetMesh mesh = mapped(
      plainMesh(), [](const Vec3& p) { return p; }, [](double v) { return 2 * v - 1; });
  scene.transferFunction = transfer({});
  const HardPicture plain = expectEveryWay(scene, mesh);
  for (const Units& units : {scalars(1e30), scalars(1e-290), scalars(1.7e308), scalars(1, 1e6)}) {
    SCOPED_TRACE(testing::Message() << units.scalar << " from " << units.offset);
    scene.transferFunction = transfer(units);
    expectLike(plain, expectEveryWay(sceneIn(units, scene), meshIn(units, mesh)), kSameInAnyUnit);
  }
}

TEST_F(Scale, BeyondTheLargestDouble) {
  tell({kGroup,
        "a bounding diagonal beyond 1.8e308 is infinite: every point went to the centre, and the picture was empty",
        "such a mesh is refused; up to there it is drawn"});
  expectLikePlain(plainScene(), plainMesh(), {lengths(4e307)});
  const Units beyond = lengths(1.7e308);
  expectRefused(sceneIn(beyond, plainScene()), meshIn(beyond, plainMesh()), "larger than the largest double");
}

TEST_F(Scale, SubnormalPositions) {
  tell({kGroup, "below 2.2e-308 doubles lose digits: at 1e-315 a place is good to 5e-9 of the mesh's size",
        "the mesh is drawn for what its numbers are"});
  const Units units{.length = 0x1p-1048};
  const HardPicture rounded = expectEveryWay(plainScene(), roundedBy(units, plainMesh()));
  expectLike(rounded, expectEveryWay(sceneIn(units, plainScene()), meshIn(units, plainMesh())), kSameInAnyUnit);
}

}  // namespace
}  // namespace havs::test
