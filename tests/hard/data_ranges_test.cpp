// Scalars and domains at the ends of what a double holds, and fields that meet the domain nowhere or at its ends only.
#include "hard/data_scenes.h"

namespace havs::test {
namespace {

using DataRanges = DataTest;

TEST_F(DataRanges, FieldOfOneValue) {
  tell({"Data", "a field of one value has a range of no width: (s - low) / (high - low) is 0 / 0",
        "a domain of one value lies in the transfer function's middle, whatever the value: 0, 1, -5, denormal or "
        "1e300"});
  expectConstant(sceneOver({}), constantBox(1), points()[1], 1);
  const HardPicture one(sceneOver({}), constantBox(1));
  for (const double value : {0.0, -0.0, -5.0, 1e-320, kLeast, 1e300, kLargest, -kLargest}) {
    expectSamePictures("other values", HardPicture(sceneOver({}), constantBox(value)), one);
    expectEveryMode(sceneOver({}), constantBox(value), value);
  }
}

TEST_F(DataRanges, EqualToTheDomainsMinimum) {
  tell({"Data", "the paper's shaders mark what is outside by the least scalar: a body of just that scalar vanishes",
        "inside and outside are told apart by the faces; every scalar of [0, 1] shows, the least included"});
  expectConstant(sceneOver(std::array{3.0, 4.0}), constantBox(3), points()[0], 3);
}

TEST_F(DataRanges, EqualToTheDomainsMaximum) {
  tell({"Data",
        "at the upper end of the domain tables are read beyond their last entry, and 1 has no room beside a kind",
        "the upper end is a scalar like any other; boundary fragments hold 1 - 2^-24 for it"});
  expectConstant(sceneOver(std::array{2.0, 3.0}), constantBox(3), points()[2], 3);
}

TEST_F(DataRanges, WhollyBelowTheDomain) {
  tell({"Data", "a field below the domain normalises to negative scalars, before the first entry of a table",
        "cut off at the domain's end: it shows as the lowest point of the transfer function, as far off as -1.8e308"});
  for (const double value : {0.999, -1e300, -kLargest})
    expectConstant(sceneOver(std::array{1.0, 2.0}), constantBox(value), points()[0], 1.5);
}

TEST_F(DataRanges, WhollyAboveTheDomain) {
  tell({"Data", "a field above the domain normalises to scalars above 1, behind the last entry of a table",
        "cut off at the domain's end: it shows as the highest point of the transfer function"});
  for (const double value : {2.001, 1e300, kLargest})
    expectConstant(sceneOver(std::array{1.0, 2.0}), constantBox(value), points()[2], 1.5);
}

TEST_F(DataRanges, Denormals) {
  tell(
      {"Data",
       "float has no room for 1e-320 and processors may flush it to 0: a field of denormals would be of one value",
       "scalars are normalised in double before anything is float: digit by digit the picture of the same steps of 1"});
  const HardPicture steps(sceneOver({}), steppedBox(1000, [](double i) { return i; }));
  const TetMesh denormal = steppedBox(1000, [](double i) { return i * kLeast; });
  expectSamePictures("against steps of 1", expectEveryWay(sceneOver({}), denormal), steps);
  expectEveryMode(sceneOver({}), denormal, 300 * kLeast);
}

TEST_F(DataRanges, NeighbouringDoubles) {
  tell({"Data", "a range of two neighbouring doubles, 1 and 1 + 2^-52: in float all is one value",
        "normalised in double, where the difference is exact: the picture of 0 and 1"});
  const auto two = [](double low, double high) { return steppedBox(1, [=](double i) { return i == 0 ? low : high; }); };
  const double next = std::nextafter(1.0, 2.0);
  const HardPicture steps(sceneOver({}), two(0, 1));
  expectSamePictures("against 0 and 1", expectEveryWay(sceneOver({}), two(1, next)), steps);
  expectSamePictures("1.8e308 and its neighbour",
                     HardPicture(sceneOver({}), two(std::nextafter(kLargest, 0.0), kLargest)), steps);
  expectEveryMode(sceneOver({}), two(1, next), next);
}

TEST_F(DataRanges, RangeWiderThanTheLargestDouble) {
  tell({"Data", "from -1.8e308 to 1.8e308 the width overflows to infinity: every scalar is 0 or NaN",
        "ends and value are halved first: digit by digit the picture of the same field at a scale that does not"});
  const double unit = std::ldexp(1.0, 1014);  // 1023 of it are the largest power of two but for a digit
  const auto wide = [](double i) { return 2 * i - 1023; };
  const TetMesh widest = steppedBox(1023, [&](double i) { return unit * wide(i); });
  const HardPicture steps(sceneOver({}), steppedBox(1023, wide));
  expectSamePictures("against a width of 2046", expectEveryWay(sceneOver({}), widest), steps);
  expectEveryMode(sceneOver({}), widest, unit * wide(300));
}

TEST_F(DataRanges, DomainOfOneValueByRequest) {
  tell({"Data", "a domain whose ends are equal, reversed, NaN or infinite: scalars would divide by 0 or infinity",
        "refused, saying which; only a field may be of one value"});
  for (const std::array<double, 2>& domain :
       {std::array{0.3, 0.3}, {1.0, 0.0}, {std::nan(""), 1.0}, {0.0, HUGE_VAL}, {-HUGE_VAL, HUGE_VAL}}) {
    Scene scene = sceneOver({});
    scene.domain = domain;
    expectRefused(scene, constantBox(0.5), "domain");
  }
  expectRefused(sceneOver(std::array{0.3, 0.3}), constantBox(0.5), "domain");
}

}  // namespace
}  // namespace havs::test
