// The lookups on SIMD lanes: the same bits by every instruction set, wherever a segment stands in the queue.
#include <gtest/gtest.h>

#include "unit/render_native/shaded.h"

namespace havs::test {
namespace {

constexpr std::size_t kSegments = 5000;

/// The number of colours that differ in any bit.
std::size_t differing(const std::vector<Color>& a, const std::vector<Color>& b) {
  std::size_t count = a.size() == b.size() ? 0 : a.size() + b.size();
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) count += bitsOf(a[i]) != bitsOf(b[i]);
  return count;
}

/// Calls check(scene) for every lookup, some transfer functions, point and cell data.
template <class Check>
void forEveryLookup(const Check& check) {
  for (const Lookup& row : lookups())
    for (const char* transfer : {"viridis", "three-peaks", "shells", "plateau-opaque"}) {
      Scene scene;
      scene.lookup = exampleName(row);
      scene.transferFunction = transfer;
      scene.tableSize = 16;
      LookupScene made(scene);
      for (bool cellData : {false, true}) {
        SCOPED_TRACE(scene.lookup + " " + transfer + (cellData ? ", cell data" : ""));
        made.plan.cellData = cellData;
        check(made);
      }
    }
}

TEST(SegmentShader, EveryInstructionSetGivesTheSameBits) {
  forEveryLookup([](const LookupScene& scene) {
    const auto given = segmentsOfAllKinds(static_cast<float>(scene.prepared.longestEdge), kSegments);
    const std::vector<Color> expected = shaded(scene.shader("scalar"), given);
    for (const std::string& name : instructionSetsHere())
      EXPECT_EQ(differing(shaded(scene.shader(name), given), expected), 0U) << name;
  });
}

TEST(SegmentShader, ASegmentDependsNeitherOnItsPlaceNorOnItsNeighbours) {
  forEveryLookup([](const LookupScene& scene) {
    const auto given = segmentsOfAllKinds(static_cast<float>(scene.prepared.longestEdge), kSegments / 4);
    const SegmentShader shader = scene.shader("");
    const std::vector<Color> expected = shaded(shader, given);
    for (std::size_t batch : {1, 7, 64, 333})
      EXPECT_EQ(differing(shaded(shader, given, batch), expected), 0U) << batch << " at a time";
    std::vector<GivenSegment> turned(given.rbegin(), given.rend());
    std::vector<Color> colors = shaded(shader, turned);
    std::reverse(colors.begin(), colors.end());
    EXPECT_EQ(differing(colors, expected), 0U) << "the other way round";
  });
}

}  // namespace
}  // namespace havs::test
