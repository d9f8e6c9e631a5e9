// Random meshes, fields, transfer functions, cameras and settings: what must be true of all of them, and what was found
// so. How many and which: random_run.h.
#include <algorithm>
#include <iostream>

#include "hard/random_run.h"
#include "hard/random_scenes.h"
#include "hard/random_shrink.h"
#include "support/meshes.h"

namespace havs::test {
namespace {

using Random = HardTest;

TEST_F(Random, ScenesOfAllKinds) {
  tell({"Random", "what nobody has thought of: cases of the other groups in one scene, in combinations",
        "thousands of small random scenes a run, more on call, each drawn and held to the truth, the same bits on any "
        "lanes, and no "
        "more opacity with fewer cells; what fails is shrunk to a few cells and kept as files"});
  const RandomRun run = asAskedFor({.seed = 20, .cases = 3000});
  std::cout << "HAVS_RANDOM_SEED=" << run.seed << std::endl;
  CaseChecker checker;
  const auto failures = runRandom(run, checker);
  const RandomTally& tally = checker.tally();
  std::cout << summaryOf(tally);
  for (const FoundFailure& f : failures) ADD_FAILURE() << "case " << f.number << ": " << f.failure;
  expectAtMost("cases that fail", static_cast<double>(failures.size()), 0);
  expectAtMost("native max where float can tell", tally.native, HardBounds{}.native);
  // A run that refuses what it made, or compares nothing, shows nothing.
  expectAtMost("share that is refused", double(tally.refused) / double(std::max<std::size_t>(tally.cases, 1)), 0.1);
  EXPECT_GT(tally.pixels, 20 * tally.cases);
  if (run.cases > 5 * run.openGl) {
    EXPECT_GT(tally.glPixels, 0u);
  }
  EXPECT_GE(tally.monotone, tally.cases / 20);
}

std::vector<std::filesystem::path> foundFolders() {
  std::vector<std::filesystem::path> folders;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(HAVS_SOURCE) / "tests/hard/found"))
    if (entry.is_directory()) folders.push_back(entry.path());
  std::sort(folders.begin(), folders.end());
  return folders;
}

/// What random scenes showed stays a case: each folder of tests/hard/found.
class RandomFound : public HardTest, public testing::WithParamInterface<std::filesystem::path> {};

TEST_P(RandomFound, StillHolds) {
  const RandomCase c = readCase(GetParam());
  tell({"Random", c.story, c.remedy});
  CaseChecker checker;
  double failures = 0;
  for (const HardWay& way : hardWays()) {
    const std::string failure = checker.failureOf(c, way.group == "native" ? nullptr : &way);
    EXPECT_EQ(failure, "") << way.name;
    failures += failure.empty() ? 0 : 1;
  }
  EXPECT_EQ(checker.tally().refused, 0u);
  expectAtMost("ways that fail", failures, 0);
}

INSTANTIATE_TEST_SUITE_P(Cases, RandomFound, testing::ValuesIn(foundFolders()),
                         [](const auto& row) { return row.param.filename().string(); });

/// The shrinker itself: a made-up fault of two cells of 200 that shows only with an isosurface.
TEST_F(Random, ShrinkingLeavesWhatFails) {
  tell({"Random", "a random scene that fails has a hundred cells and twenty settings, of which two matter",
        "delta debugging over cells, settings, control points, picture and digits"});
  Dice dice(1);
  RandomCase c;
  while (c.mesh.tetrahedra.size() < 50 || !c.scene.contains("isosurfaces") || c.transfer["points"].size() < 5)
    c = randomCase(dice);
  const auto fails = [](const RandomCase& next) {
    const auto& points = next.mesh.points;
    std::size_t above = 0;
    for (const Tetrahedron& cell : next.mesh.tetrahedra)
      above += std::any_of(cell.begin(), cell.end(), [&](Index i) { return points[i].x > 0; }) ? 1 : 0;
    return above >= 2 && next.scene.contains("isosurfaces") && !next.transfer["points"].empty();
  };
  for (Vec3& p : c.mesh.points) p.x += 1e3;  // so that it fails at first
  ASSERT_TRUE(fails(c));
  const RandomCase small = shrunk(c, fails, 5000);
  EXPECT_TRUE(fails(small));
  expectAtMost("cells left, of which 2 are needed", static_cast<double>(small.mesh.tetrahedra.size()), 2);
  expectAtMost("settings left", static_cast<double>(small.scene.size()), 2);  // the picture's size, too
  expectAtMost("control points left", static_cast<double>(small.transfer["points"].size()), 1);
  EXPECT_LE(small.mesh.points.size(), 8u);
  for (const Vec3& p : small.mesh.points) EXPECT_TRUE(p.x == 0 || p.x == 1) << p.x;
}

/// A case that is kept is the case that failed: bit for bit.
TEST_F(Random, CasesAreTheSameFromTheirFiles) {
  tell({"Random", "a failure that was written with fewer digits is no failure when it is read again",
        "cases are held as the content of the files that they are drawn from; numbers have all their digits"});
  const TemporaryFolder folder;
  Dice dice(7);
  double differing = 0;
  for (int i = 0; i < 20; ++i) {
    RandomCase c = randomCase(dice);
    writeCase(c, folder / std::to_string(i));
    const RandomCase read = readCase(folder / std::to_string(i));
    const bool same = read.scene == c.scene && read.transfer == c.transfer && read.mesh.points == c.mesh.points &&
                      read.mesh.tetrahedra == c.mesh.tetrahedra && read.overlaps == c.overlaps;
    EXPECT_TRUE(same) << c.scene.dump();
    differing += same ? 0 : 1;
  }
  expectAtMost("cases that differ", differing, 0);
}

}  // namespace
}  // namespace havs::test
