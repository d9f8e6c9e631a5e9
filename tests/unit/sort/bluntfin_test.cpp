// The mesh of the paper's tables: curved, strongly stretched, non-convex.
#include <gtest/gtest.h>

#include <filesystem>

#include "mesh/defects.h"
#include "mesh/read.h"
#include "support/ordered_scene.h"
#include "support/views.h"

namespace havs {
namespace {

TEST(BluntFin, TopologicalOrderIsExactWhereTheCentroidOrderIsNot) {
  const std::filesystem::path file = std::filesystem::path(HAVS_SHARED_DATA) / "bluntfinxyz.bin";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
  const test::OrderedScene scene(repairMesh(readMesh(file)));
  for (const double azimuth : {30.0, 120.0, 250.0}) {
    const View view = test::viewFrom(scene.frame, azimuth, 20, 128);
    // Repair leaves out the 77 flat cells of the grid's collapsed edge: which of two cells there is in front is a guess, wrong for one
    // fragment of the three views (of a million), and mended by a second entry.
    EXPECT_LE(scene.replay("topological", view, 1).misordered, 1u);
    EXPECT_EQ(scene.replay("topological", view, 2).misordered, 0u);
    const auto centroid = scene.replay("centroid", view, 6);
    EXPECT_GT(centroid.misordered, centroid.fragments / 20);  // 7 to 16% of the fragments at k = 6
    EXPECT_EQ(centroid.unbalancedPixels, 0u);
  }
}

}  // namespace
}  // namespace havs
