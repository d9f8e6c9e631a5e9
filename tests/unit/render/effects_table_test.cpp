// The rows of effects(): each can be asked for and left out.
#include "effect_plans.h"

namespace havs::test {
namespace {

// A row without these would be left out of the tests above, and of studies.
TEST(Effects, EachRowCanBeAddedAndRemoved) {
  for (const Effect& effect : effects()) {
    SCOPED_TRACE(effect.name);
    EXPECT_NE(effect.description, "");
    ASSERT_NE(effect.wanted, nullptr);
    ASSERT_NE(effect.add, nullptr);
    ASSERT_NE(effect.remove, nullptr);
    ASSERT_NE(effect.check, nullptr);
    ASSERT_NE(effect.plan, nullptr);
    Scene scene;
    EXPECT_FALSE(effect.wanted(scene)) << "a scene that mentions no effect has none";
    effect.add(scene, {});
    EXPECT_TRUE(effect.wanted(scene));
    EXPECT_NO_THROW(checkScene(scene));
    effect.remove(scene);
    EXPECT_FALSE(effect.wanted(scene));
  }
}

// What implies an effect goes with it; nothing else does, but for its own settings.
TEST(Effects, RemovingOneLeavesTheOthersThatDoNotImplyIt) {
  for (const EffectSubset& subset : subsetsUpToPairs()) {
    if (subset.size() < 2) continue;
    SCOPED_TRACE(nameOf(subset));
    for (const int first : {0, 1}) {
      const Effect &gone = *subset[static_cast<std::size_t>(first)],
                   &other = *subset[static_cast<std::size_t>(1 - first)];
      const bool implied = gone.wanted(with({}, {&other}));
      Scene scene = with({}, subset);
      gone.remove(scene);
      EXPECT_FALSE(gone.wanted(scene));
      EXPECT_EQ(other.wanted(scene), !implied) << other.name;
    }
  }
}

TEST(Effects, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const Effect& effect : effects()) EXPECT_TRUE(names.insert(effect.name).second) << effect.name;
}

}  // namespace
}  // namespace havs::test
