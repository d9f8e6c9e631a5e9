// Sums over many thin layers.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/run_havs.h"
#include "hard/layered_column.h"
#include "mesh/read.h"
#include "reference/reference_renderer.h"
#include "render/devices.h"

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

TEST_F(Accumulation, HundredThousandThinLayers) {
  tell({"Accumulation",
        "a layer of optical depth 1e-5 as 1 - exp(-x) has lost five digits in float, and 1e5 of them in a row add up "
        "what each has lost",
        "layers have the relative accuracy of their own depth; what is left is the rounding of the sum"});
  const Scene scene = columnScene();
  const HardPicture picture = expectEveryWay(scene, layeredColumn(kLayers));
  expectAtMost("reference to closed form", offFromColumn(picture.truth, picture.view), 1e-7);
  for (const HardDrawing& one : picture.drawings)
    expectAtMost(one.way.group + " to closed form", offFromColumn(one.drawing.image, picture.view),
                 one.way.group == "native" ? 1e-5 : 2e-5);
  const havs::Drawing cells = drawIn(kCells, scene, picture.prepared, picture.view);
  expectAtMost("cells to closed form", offFromColumn(cells.image, picture.view), 2e-5);
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
    expectAtMost(fmt::format("32f, {} layers", layers), whole, 2e-5);
    expectAtMost(fmt::format("16f, {} layers (lost: what is reported)", layers), half, 1);
    EXPECT_GE(half, 100 * whole);
  }
}

TEST_F(Accumulation, ThinLayersInTablesOfFewBits) {
  tell({"Accumulation",
        "a table of 8 bits has no opacity between 0 and 1/255: a hundred thousand layers of 1e-5 show nothing or far "
        "too much",
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
        if (format == "rgba8") EXPECT_GE(few, 0.1);
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
  EXPECT_GE(errors.at("column-0/table-format=rgba8"), 0.1);
}

}  // namespace
}  // namespace havs::test
