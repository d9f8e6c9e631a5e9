// A pixel that ends early lacks at most what light was left.
#include <fmt/format.h>

#include "hard/boxes.h"
#include "hard/layered_column.h"

namespace havs::test {
namespace {

class Accumulation : public HardPictureTest {
 protected:
  /// Draws with several thresholds in every way. No channel may lose more than 1 - threshold, or gain anything.
  void expectBounded(const Scene& scene, const TetMesh& mesh) {
    constexpr double kRounding = 1e-6;
    StageTimes stages;
    const PreparedScene prepared = prepareScene(scene, mesh, stages);
    const View view = viewOf(scene, prepared);
    for (const HardWay& way : hardWays()) {
      const Image whole = drawIn(way, scene, prepared, view).image;
      double changed = 0;
      for (const double threshold : {0.3, 0.9, 0.99, 0.999}) {
        SCOPED_TRACE(way.name);
        Scene early = scene;
        early.earlyTermination = threshold;
        const Image image = drawIn(way, early, prepared, view).image;
        EXPECT_EQ(notAPicture(image), "");
        double lost = 0, gained = 0;
        for (std::size_t i = 0; i < whole.rgba.size(); ++i) {
          const double difference = double{whole.rgba[i]} - double{image.rgba[i]};
          lost = std::max(lost, difference);
          gained = std::max(gained, -difference);
          changed = std::max(changed, difference);
          if (i % 4 == 3 && whole.rgba[i] < threshold) EXPECT_EQ(image.rgba[i], whole.rgba[i]);
        }
        expectAtMost(fmt::format("{}, ends at {}: lost, as a part of what may be", way.group, threshold),
                     lost / (1 - threshold + kRounding), 1);
        expectAtMost("gained", gained, kRounding);
      }
      EXPECT_GT(changed, 0) << "no pixel of " << way.name << " ended early";
    }
  }
};

TEST_F(Accumulation, EarlyTerminationOfADenseVolume) {
  tell(
      {"Accumulation", "a pixel that is done at 0.99 is taken for one of opacity 1, or its last segment left out",
       "it stops behind the segment that reaches the threshold and keeps what it has: it lacks 1 - threshold at most"});
  Scene scene = hardScene(32);
  scene.certificate = false;
  scene.transferFunction = transferFile(transferOf({{0, 0.2, 0.4, 0.8, 0.1}, {1, 1, 0.5, 0.1, 12}}));
  TetMesh mesh = ball(5);
  auto values = smoothField(mesh.points);
  expectBounded(scene, withPoints(std::move(mesh), std::move(values)));
}

TEST_F(Accumulation, EarlyTerminationOfThinLayers) {
  tell({"Accumulation", "the threshold is reached by thousands of layers, each too thin to be seen",
        "as for any volume: the sum so far is what is compared"});
  Scene scene = columnScene();
  scene.certificate = false;
  scene.transferFunction = transferFile(transferOf({{0, 1, 1, 1, 10}, {1, 1, 0.3, 0.6, 10}}));
  expectBounded(scene, layeredColumn(800));
}

TEST_F(Accumulation, EarlyTerminationBeforeAnOpaqueSurface) {
  tell({"Accumulation", "behind the haze in which a pixel ends lies a white surface, the most that can be lost",
        "the surface is behind what ends the pixel: its light is what was left"});
  Scene scene = hardScene(32);
  scene.certificate = false;
  scene.transferFunction = transferFile(
      transferOf({{0, 0, 0, 0, 0.6}, {0.5, 0, 0, 0.1, 0.9}, {0.5, 1, 1, 1, 1}, {1, 1, 1, 1, 1}}, "per_unit", 0.5));
  expectBounded(scene, SlantedBox{}.mesh());
}

}  // namespace
}  // namespace havs::test
