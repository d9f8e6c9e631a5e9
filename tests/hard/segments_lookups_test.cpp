// Every lookup over what is hard: finite, a colour, and as exact as its kind can be; and what a table cannot resolve.
#include <map>

#include "hard/boxes.h"
#include "reference/edge_mask.h"
#include "render/devices.h"
#include "render/lookups.h"
#include "render/make_renderer.h"
#include "study/choose_settings.h"

namespace havs::test {
namespace {

using Segments = HardPictureTest;
using Points = SegmentTruth::Points;

constexpr double kAlmost = 1 - 0x1p-24;
const HardWay kNative{"native", "native", kNativeDevice, "kbuffer", "topological", 6};
const HardWay kKBuffer{"k-buffer", "k-buffer", "osmesa", "kbuffer", "topological", 6};
const HardWay kABuffer{"a-buffer", "a-buffer", "osmesa", "abuffer", "topological", 6};

struct Prepared {
  Scene scene;
  PreparedScene prepared;
  View view;
  Image truth;
  std::vector<unsigned char> mask;
};

Prepared prepare(const Scene& scene, const TetMesh& mesh) {
  StageTimes stages;
  Prepared made{scene, prepareScene(scene, mesh, stages), {}, {}, {}};
  made.view = viewOf(scene, made.prepared);
  made.truth = makeReference(scene, made.prepared)->draw(made.view, stages).image;
  made.mask = boundaryEdgeMask(made.prepared.points, made.prepared.faces, made.view);
  return made;
}

ErrorMeasures errorOf(const Image& picture, const Prepared& made) {
  return compareImages(picture, made.truth, made.mask).rgba;
}

Scene lookupScene(const Points& points, const std::string& meaning, double unitLength) {
  Scene scene = hardScene(32);
  scene.certificate = false;
  scene.tableSize = 16;
  scene.transferFunction = transferFile(transferOf(points, meaning, unitLength));
  return scene;
}

TEST_F(Segments, EveryLookupStaysAColour) {
  tell({"Segments",
        "divisions by a segment's length, by back - front, by an opacity of 0 or by 1 - opacity give NaN or colours "
        "beyond 1 in one lookup or other",
        "no lookup divides by what can be 0 but selects another divisor; mean colours are made with a trace of "
        "extinction; light is at most the opacity"});
  const std::vector<std::pair<Points, double>> functions{
      {{{0, 1, 1, 1, 0}, {0.25, 1, 0.4, 0.4, 0}, {0.5, 1, 1, 0.7, 1}, {0.75, 1, 1, 1, 1}, {1, 1, 1, 1, 0}}, 0.3},
      {{{0, 1, 1, 1, kAlmost}, {1, 0.5, 1, 0, kAlmost}}, 0.01},
      {{{0, 1, 1, 1, 0}, {0.5, 1, 1, 1, 0}, {0.5, 1, 1, 1, kAlmost}, {1, 0, 1, 1, 1e-8}}, 1e-3},
      {{{0, 1, 1, 1, 0}, {1, 1, 1, 1, 1e-8}}, 1e6}};
  for (const auto& [points, unitLength] : functions)
    for (const SlantedBox& box : {SlantedBox{}, SlantedBox{0.5, 0}, SlantedBox{0.3, 1e-7}}) {
      Prepared made = prepare(lookupScene(points, "per_unit", unitLength), box.mesh());
      for (const Lookup& row : lookups()) {
        made.scene.lookup = exampleName(row);
        const bool onOpenGl = unitLength == 0.3 && box.range == 1;
        for (const HardWay* way : {&kNative, &kKBuffer, &kABuffer}) {
          if (way != &kNative && !onOpenGl) continue;
          if (row.carries == Payload::color && !visibilityMethod(way->visibility).carriesColors) continue;
          const havs::Drawing drawing = drawIn(*way, made.scene, made.prepared, made.view);
          const std::string wrong = notAPicture(drawing.image);
          EXPECT_EQ(wrong, "") << made.scene.lookup << ", " << way->name << ", unit length " << unitLength;
          expectAtMost(way->name + ": lookups that are no colour", wrong.empty() ? 0 : 1, 0);
        }
      }
    }
}

TEST_F(Segments, EveryLookupIsAsExactAsItsKind) {
  tell({"Segments",
        "with equal ends, no length and a linear function all lookups should nearly agree; where one divides wrongly "
        "it leaves its class",
        "what each keeps of the integral is stated (docs/02-method.md), and each is held to it"});
  // Colour and extinction are linear over the scalar, so `exact` and `pre` have no error but float's. Others: measured
  // here and rounded up to one digit; tables have 16 entries a side.
  const std::map<std::string, double> bounds{{"exact", 2e-5},         {"pre", 3e-5},       {"3d", 2e-3},
                                             {"3d-normalised", 3e-5}, {"2d", 4e-3},        {"integral", 2e-1},
                                             {"post", 4e-3},          {"riemann:8", 2e-4}, {"riemann-linear:8", 2e-2}};
  Prepared made =
      prepare(lookupScene({{0, 0.2, 0.4, 0.8, 0.3}, {1, 0.9, 0.5, 0.1, 1.3}}, "extinction", 1), SlantedBox{}.mesh());
  for (const Lookup& row : lookups()) {
    made.scene.lookup = exampleName(row);
    for (const HardWay* way : {&kNative, &kKBuffer})
      expectAtMost(made.scene.lookup, errorOf(drawIn(*way, made.scene, made.prepared, made.view).image, made).p999,
                   bounds.at(made.scene.lookup));
  }
}

TEST_F(Segments, LightOfIntegralStaysBelowItsOpacity) {
  tell(
      {"Segments",
       "`integral` leaves the attenuation inside a segment out of its light: before this case a white segment of depth "
       "1 had light 1 and opacity 0.63, so many of them add up to 1.58; the k-buffer cuts that off at 1, the a-buffer "
       "does not",
       "light is at most the opacity, as colours are at most 1; what is white is exact now"});
  Prepared made = prepare(lookupScene({{0, 1, 1, 1, 0.5}, {1, 1, 0.5, 1, 0.99}}, "per_unit", 0.5), SlantedBox{}.mesh());
  made.scene.lookup = "integral";
  for (const HardWay* way : {&kNative, &kKBuffer, &kABuffer}) {
    const Image image = drawIn(*way, made.scene, made.prepared, made.view).image;
    EXPECT_EQ(notAPicture(image), "") << way->name;
    double beyond = -1, red = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
      for (std::size_t c = 0; c < 3; ++c)
        beyond = std::max(beyond, double{image.rgba[i + c]} - double{image.rgba[i + 3]});
      if (made.mask[i / 4] == 0) red = std::max(red, std::abs(double{image.rgba[i]} - double{made.truth.rgba[i]}));
    }
    expectAtMost(way->name + ": light beyond opacity", beyond, 1e-6);  // compositing rounds each alike
    expectAtMost(way->name + ": error of the white channel", red, way == &kNative ? 1e-5 : 2e-4);
  }
}

/// A peak of opacity a thousandth of the domain wide: an eighth of a cell of a table of 128 entries.
const Points kNarrow{{0, 0.1, 0.2, 0.9, 0.02},
                     {0.4990, 0.1, 0.2, 0.9, 0.02},
                     {0.4995, 1, 0.6, 0.1, 400},
                     {0.5, 0.1, 0.2, 0.9, 0.02},
                     {1, 0.1, 0.2, 0.9, 0.02}};

TEST_F(Segments, TransferFunctionNarrowerThanATableCell) {
  tell({"Segments",
        "between entries of `3d` a table is linear: a peak narrower than its cells is missed or smeared, and no "
        "picture says so",
        "`exact` cuts at the control points; `compare`, `study` and `--max-error --verify` measure what `3d` loses, "
        "and `--max-error` does not choose it"});
  Prepared made = prepare(lookupScene(kNarrow, "extinction", 1), SlantedBox{0, 1, 6}.mesh());
  made.scene.tableSize = 128;
  made.scene.device = kNative.device;
  std::map<std::string, double> error;
  for (const std::string name : {"exact", "3d"}) {
    made.scene.lookup = name;
    error[name] = errorOf(drawIn(kNative, made.scene, made.prepared, made.view).image, made).p999;
  }
  expectAtMost("`exact`", error["exact"], 1e-5);
  expectAtMost("`3d` of 128 (off: what is reported)", error["3d"], 1);
  EXPECT_GE(error["3d"], 0.02);
  for (const double asked : {0.01, 0.001}) {
    const ErrorGoal goal{asked};
    const ChosenSettings chosen = chooseSettings(made.scene, made.prepared, goal);
    EXPECT_NE(chosen.scene.lookup, "3d");
    const Image image = drawIn(kNative, chosen.scene, made.prepared, made.view).image;
    expectAtMost("of the error asked for", trueError(chosen.scene, made.prepared, image, goal) / asked, 1);
  }
}

}  // namespace
}  // namespace havs::test
