// Sums over many thin layers.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/run_havs.h"
#include "core/error.h"
#include "hard/layered_column.h"
#include "mesh/read.h"
#include "reference/reference_renderer.h"
#include "render/devices.h"
#include "render/make_renderer.h"

namespace havs::test {
namespace {

using Accumulation = HardPictureTest;

constexpr int kLayers = 100000;
const HardWay kNative{"native", "native", kNativeDevice, "kbuffer", "topological", 6};
const HardWay kKBuffer{"k-buffer", "k-buffer", "osmesa", "kbuffer", "topological", 6};
const HardWay kCells{"cells", "cells", "osmesa", "cells", "topological", 6};

struct Column {
  PreparedScene prepared;
  View view;
};

Column columnOf(const Scene& scene, int layers) {
  StageTimes stages;
  Column column{prepareScene(scene, layeredColumn(layers), stages), {}};
  column.view = viewOf(scene, column.prepared);
  return column;
}

/// Of a ray through `layers` prisms: each of its segments rounds the sum by half a step of float at most.
double boundOfSum(int layers) { return 3 * layers * 0x1p-25; }

TEST_F(Accumulation, HundredThousandThinLayers) {
  tell({"Accumulation",
        "a layer of optical depth 1e-5 as 1 - exp(-x) has lost five digits in float, and 1e5 of them in a row add up "
        "what each has lost",
        "layers have the relative accuracy of their own depth; what is left is the rounding of the sum, 300,000 times "
        "half a step of float at most"});
  Scene scene = columnScene();
  scene.certificate = false;
  for (const int layers : {1000, kLayers}) {
    const Column column = columnOf(scene, layers);
    StageTimes stages;
    const Image truth = makeReference(scene, column.prepared)->draw(column.view, stages).image;
    expectAtMost(fmt::format("reference to closed form, {} layers", layers), offFromColumn(truth, column.view), 1e-7);
    for (const HardWay* way : {&kNative, &kKBuffer, &kCells}) {
      const Image image = drawIn(*way, scene, column.prepared, column.view).image;
      EXPECT_EQ(notAPicture(image), "");
      expectAtMost(fmt::format("{}, {} layers", way->name, layers), offFromColumn(image, column.view),
                   boundOfSum(layers));
    }
  }
}

TEST_F(Accumulation, ListsLongerThanTheDriversLoops) {
  tell({"Accumulation",
        "before this case the a-buffer drew nothing of a pixel with 6,000 fragments, and part of one with 3,000: "
        "llvmpipe "
        "ends all loops of a shader after 65,535 turns together, without a word",
        "a list that was not gone through to its end is told, with what to try; shorter ones are exact"});
  Scene scene = columnScene();
  scene.certificate = false;
  const HardWay abuffer{"a-buffer", "a-buffer", "osmesa", "abuffer", "topological", 6};
  const Column few = columnOf(scene, 800);
  expectAtMost("a-buffer, 800 layers", offFromColumn(drawIn(abuffer, scene, few.prepared, few.view).image, few.view),
               boundOfSum(800));
  double silent = 0;
  for (const int layers : {1000, 2000, 40000}) {
    const Column many = columnOf(scene, layers);
    try {
      const Image image = drawIn(abuffer, scene, many.prepared, many.view).image;
      if (!(offFromColumn(image, many.view) <= boundOfSum(layers))) ++silent;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("--visibility kbuffer"), std::string::npos) << error.what();
    }
  }
  expectAtMost("wrong pictures without a word", silent, 0);
}

TEST_F(Accumulation, ThinLayersInHalfFloats) {
  tell({"Accumulation",
        "in 16F targets a layer that adds less than half a step to the opacity adds nothing, and layers thinner than a "
        "step of the distance have no length",
        "16F is kept to show that, is not the default, and its loss is measured: here, and by the study"});
  Scene scene = columnScene();
  scene.certificate = false;
  for (const int layers : {1000, kLayers}) {
    const Column column = columnOf(scene, layers);
    scene.targetFormat = "32f";
    const double whole = offFromColumn(drawIn(kKBuffer, scene, column.prepared, column.view).image, column.view);
    scene.targetFormat = "16f";
    const double half = offFromColumn(drawIn(kKBuffer, scene, column.prepared, column.view).image, column.view);
    expectAtMost(fmt::format("32f, {} layers", layers), whole, boundOfSum(layers));
    expectAtMost(fmt::format("16f, {} layers (lost: what is reported)", layers), half, 1);
    EXPECT_GE(half, 10 * whole);
  }
}

TEST_F(Accumulation, ThinLayersInTablesOfFewBits) {
  tell({"Accumulation",
        "in 8 bits the opacity of the shortest length of a table is off by a part of itself, and so is that of each of "
        "ten thousand layers",
        "`3d-normalised` keeps opacity out of the table, and `2d` as an extinction; what `3d` loses is measured"});
  Scene scene = columnScene();
  scene.certificate = false;
  const Column column = columnOf(scene, kLayers / 10);
  // Half a step of the format, of mean colours times an opacity below 1; and what the table's own size leaves.
  for (const auto& [format, halfStep] : {std::pair<std::string, double>{"rgba8", 0.5 / 255}, {"rgba16f", 0x1p-12}})
    for (const std::string lookup : {"3d", "2d", "3d-normalised"}) {
      scene.lookup = lookup;
      scene.tableSize = 64;
      scene.tableFormat = "rgba32f";
      const double whole = offFromColumn(drawIn(kNative, scene, column.prepared, column.view).image, column.view);
      scene.tableFormat = format;
      const double few = offFromColumn(drawIn(kNative, scene, column.prepared, column.view).image, column.view);
      if (lookup == "3d") {
        expectAtMost("3d, " + format + " (lost: what is reported)", few, 1);
        if (format == "rgba8") EXPECT_GE(few, halfStep);
      } else {
        expectAtMost(lookup + ", " + format + ", more than with rgba32f", few - whole, halfStep + 1e-5);
      }
    }
}

TEST_F(Accumulation, TheStudyShowsWhatFewBitsLose) {
  tell({"Accumulation", "a loss that no report shows is taken for a picture of the data",
        "`havs study --axis target-format --axis table-format` states the error of each format against the reference"});
  const TemporaryFolder folder;
  writeMesh(layeredColumn(kLayers / 10), folder / "column.node");
  folder.write("tf.json", transferOf({{0, 0.2, 0.9, 0.1, 1}, {1, 0.9, 0.3, 0.6, 1}}));
  const Outcome run =
      runHavs({"study",          "column.node",
               "--out",          "out",
               "--tf",           "tf.json",
               "--size",         "4x4",
               "--projection",   "orthographic",
               "--camera",       R"({"azimuth": 4, "elevation": 3, "target": [0, 0, 0], "view_height": 0.4})",
               "--lookup",       "3d",
               "--table",        "32",
               "--axis",         "target-format",
               "--axis",         "table-format",
               "--axis",         "lookup=exact",
               "--repeat",       "1",
               "--combinations", "0",
               "--quiet"},
              folder.path());
  ASSERT_EQ(run.status, 0) << run.error;
  const auto study = nlohmann::json::parse(contentOf(folder / "out/study.json"));
  std::map<std::string, double> errors;
  for (const auto& one : study["runs"]) errors[one["id"]] = one["error"]["p999"];
  expectAtMost("exact, 32f", errors.at("column-0/lookup=exact"), 2e-5);
  expectAtMost("16f, as the study states", errors.at("column-0/target-format=16f"), 1);
  expectAtMost("3d in rgba8, as the study states", errors.at("column-0/table-format=rgba8"), 1);
  EXPECT_GE(errors.at("column-0/target-format=16f"), 0.001);
  EXPECT_GE(errors.at("column-0/table-format=rgba8"), 0.5 / 255);
}

}  // namespace
}  // namespace havs::test
