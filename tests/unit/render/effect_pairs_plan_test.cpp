// The plan holds what the scene's effects call for together and nothing else: for every subset of the rows of effects()
// up to pairs, every mode, visibility method and lookup, both kinds of device, and every kind of data.
#include "effect_plans.h"

namespace havs::test {
namespace {

class PlansOfPairs : public EffectPlans {};
HAVS_FOR_EVERY_WAY(PlansOfPairs);

// A pair is refused if and only if one of the two is.
TEST_P(PlansOfPairs, OfAPairHoldsWhatTheTwoCallForAndNothingElse) {
  forEachLookup([&](const std::string& lookup) {
    const Scene plain = sceneOf(lookup);
    for (int bits = 0; bits < kKindsOfFacts; ++bits) {
      const SceneFacts facts = factsOf(bits);
      const auto none = planned(plain, facts);
      ASSERT_TRUE(none);
      for (const EffectSubset& subset : subsetsUpToPairs()) {
        if (subset.size() < 2) continue;
        SCOPED_TRACE(nameOf(subset));
        const auto a = planned(with(plain, {subset[0]}), facts), b = planned(with(plain, {subset[1]}), facts);
        const auto both = planned(with(plain, subset), facts);
        ASSERT_EQ(both.has_value(), a.has_value() && b.has_value());
        if (!both) continue;
        const Contents expected = joined(contentsOf(*none), joined(contentsOf(*a), contentsOf(*b)));
        EXPECT_EQ(difference(expected, contentsOf(*both)), "");
        const bool lit = a->light.lit || b->light.lit;
        EXPECT_EQ(both->light.lit, lit);
        EXPECT_EQ(both->lookup.carries, lit ? Payload::lit : none->lookup.carries);
      }
    }
  });
}

// Nothing is taken twice: of what both have, at most the sum, and at least the larger.
TEST_P(PlansOfPairs, OfAPairTakesNoMoreBytesThanTheTwo) {
  forEachLookup([&](const std::string& lookup) {
    const Scene plain = sceneOf(lookup);
    for (const EffectSubset& subset : subsetsUpToPairs()) {
      const auto both = planned(with(plain, subset));
      if (subset.size() < 2 || !both) continue;
      SCOPED_TRACE(nameOf(subset));
      auto a = bytesOf(*planned(with(plain, {subset[0]}))), b = bytesOf(*planned(with(plain, {subset[1]})));
      for (const auto& [name, bytes] : bytesOf(*both)) {
        EXPECT_LE(bytes, a[name] + b[name]) << name;
        EXPECT_GE(bytes, std::max(a[name], b[name])) << name;
      }
    }
  });
}

TEST_P(PlansOfPairs, EachEffectAddsToThePlanAndTakesNothingAway) {
  forEachLookup([&](const std::string& lookup) {
    const Scene plain = sceneOf(lookup);
    const Contents none = contentsOf(*planned(plain));
    for (const Effect& effect : effects()) {
      if (effect.wanted(plain)) continue;
      SCOPED_TRACE(effect.name);
      const auto with = planned(havs::test::with(plain, {&effect}));
      if (!with) continue;
      EXPECT_EQ(joined(none, contentsOf(*with)), contentsOf(*with)) << "something is gone";
      EXPECT_NE(none, contentsOf(*with)) << "the plan does not say what it takes";
    }
  });
}

TEST_P(PlansOfPairs, DoesNotDependOnTheOrderInWhichTheyAreAskedFor) {
  const Scene plain = sceneOf("exact");
  for (const EffectSubset& subset : subsetsUpToPairs()) {
    if (subset.size() < 2) continue;
    SCOPED_TRACE(nameOf(subset));
    const auto one = planned(with(plain, subset)), other = planned(with(plain, {subset[1], subset[0]}));
    ASSERT_EQ(one.has_value(), other.has_value());
    if (!one) continue;
    EXPECT_EQ(contentsOf(*one), contentsOf(*other));
    EXPECT_EQ(bytesOf(*one), bytesOf(*other));
  }
}

TEST_P(PlansOfPairs, NoItemIsListedTwiceAndEachSaysWhy) {
  for (int bits = 0; bits < kKindsOfFacts; ++bits)
    for (const EffectSubset& subset : subsetsUpToPairs()) {
      const auto chosen = planned(with(sceneOf("exact"), subset), factsOf(bits));
      if (!chosen) continue;
      SCOPED_TRACE(nameOf(subset));
      std::set<std::string> names;
      for (const PlanItem& item : chosen->items) {
        EXPECT_TRUE(names.insert(std::string(nameOf(item.kind)) + item.name).second) << item.name;
        EXPECT_NE(item.reason, "") << item.name;
      }
      std::set<std::string> defines;
      for (const ShaderDefine& define : chosen->defines) EXPECT_TRUE(defines.insert(define.name).second) << define.name;
    }
}

}  // namespace
}  // namespace havs::test
