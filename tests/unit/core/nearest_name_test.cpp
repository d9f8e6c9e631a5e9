#include "core/nearest_name.h"

#include <gmock/gmock.h>

namespace havs {
namespace {

const std::vector<std::string> kNames{"centroid", "topological", "exact", "none"};

TEST(NearestName, FewestEditsWin) {
  EXPECT_EQ(nearestName("centriod", kNames), "centroid");
  EXPECT_EQ(nearestName("topologic", kNames), "topological");
  EXPECT_EQ(nearestName("exakt", kNames), "exact");
  EXPECT_EQ(nearestName("", kNames), "none");  // four insertions, the fewest
}

TEST(NearestName, LettersCaseIsFree) { EXPECT_EQ(nearestName("NONE", kNames), "none"); }

TEST(NearestName, NothingToChooseFrom) { EXPECT_EQ(nearestName("x", {}), ""); }

TEST(DidYouMean, NamesTheNearestAndListsAll) {
  EXPECT_EQ(didYouMean("exakt", kNames), "did you mean 'exact'? known: centroid, topological, exact, none");
  EXPECT_EQ(didYouMean("x", {}), "there is none to choose from");
}

TEST(DidYouMean, ListsAtMost24) {
  const std::vector<std::string> many(25, "name");
  EXPECT_THAT(didYouMean("x", many), testing::EndsWith("name, ..."));
}

}  // namespace
}  // namespace havs
