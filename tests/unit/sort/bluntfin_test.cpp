// The mesh of the paper's tables: curved, strongly stretched, non-convex.
#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>

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
    // Repair leaves out the 77 flat cells of the grid's collapsed edge: which of two cells there is in front is a
    // guess, wrong for one fragment of the three views (of a million), and mended by a third entry: it is an exit at
    // the place of an entry, which one of two entries may draw before it.
    EXPECT_LE(scene.replay("topological", view, 1).misordered, 1u);
    EXPECT_LE(scene.replay("topological", view, 2).misordered, 1u);
    EXPECT_EQ(scene.replay("topological", view, 3).misordered, 0u);
    const auto centroid = scene.replay("centroid", view, 6);
    EXPECT_GT(centroid.misordered, centroid.fragments / 20);  // 7 to 16% of the fragments at k = 6
    EXPECT_EQ(centroid.unbalancedPixels, 0u);
  }
}

// The default view at 512 x 512: exact in topological order whatever k; how far the paper's order is from it is
// printed.
TEST(BluntFin, MisorderedFragmentsAtEveryK) {
  const std::filesystem::path file = std::filesystem::path(HAVS_SHARED_DATA) / "bluntfinxyz.bin";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
  const test::OrderedScene scene(repairMesh(readMesh(file)));
  const View view = test::viewFrom(scene.frame, 30, 20, 512);
  const std::vector<int> every{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14};
  for (const auto& result : scene.replay("topological", view, every)) EXPECT_EQ(result.misordered, 0u);
  const std::vector<int> shown{2, 6, 14};
  const auto centroid = scene.replay("centroid", view, shown);
  for (std::size_t i = 0; i < shown.size(); ++i)
    std::cout << "centroid, k = " << shown[i] << ": " << centroid[i].misordered << " of " << centroid[i].fragments
              << " fragments misordered, in " << centroid[i].misorderedPixels << " pixels\n";
}

}  // namespace
}  // namespace havs
