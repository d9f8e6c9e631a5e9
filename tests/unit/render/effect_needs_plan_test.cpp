// What plans hold only for effects, modes and lookups that need it: light, an order, tables.
#include "effect_plans.h"

namespace havs::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class PlanNeeds : public EffectPlans {};
HAVS_FOR_EVERY_WAY(PlanNeeds);

TEST_P(PlanNeeds, WithoutLightHoldNothingOfLight) {
  forEachLookup([&](const std::string& lookup) {
    for (const EffectSubset& subset : subsetsUpToPairs()) {
      const auto chosen = planned(with(sceneOf(lookup), subset));
      if (!chosen || chosen->light.lit) continue;
      SCOPED_TRACE(nameOf(subset));
      EXPECT_EQ(chosen->light.rowLength, 0);
      EXPECT_NE(chosen->lookup.carries, Payload::lit);
      for (const std::string& name : contentsOf(*chosen))
        for (const char* part : {"gradient", "LIT", "LIGHT", "PHONG", "SHADOW", "OCCLUSION", "SCATTERED", "tracer"})
          EXPECT_THAT(name, Not(HasSubstr(part)));
    }
  });
}

/// Numbers of a point that each effect of light needs, and whether light is traced for it.
TEST_P(PlanNeeds, OfLightHoldTheNumbersThatTheyUse) {
  for (const EffectSubset& subset : subsetsUpToPairs()) {
    const auto chosen = planned(with(sceneOf("exact"), subset));
    if (!chosen || !chosen->light.lit) continue;
    SCOPED_TRACE(nameOf(subset));
    const LightPlan& light = chosen->light;
    const bool byGradient = light.phong || light.modulation > 0;
    EXPECT_EQ(light.gradientAt >= 0, byGradient);
    EXPECT_EQ(light.rowLength, (byGradient ? 3 : 0) + (light.occlusion ? 1 : 0) + (light.scattering ? 1 : 0) +
                                   (light.shadowsAt >= 0 ? static_cast<int>(light.lights.size()) : 0));
    const Contents contents = contentsOf(*chosen);
    const bool traced = light.occlusion || light.scattering || light.shadowsAt >= 0;
    EXPECT_EQ(contents.contains("precomputation: gradients at the points in stage gradients"), byGradient);
    EXPECT_EQ(contents.contains("precomputation: the mesh as light goes through it in stage tracer"), traced);
    EXPECT_EQ(light.lights.empty(), !light.phong && !light.scattering) << "lights that light nothing";
  }
}

// Whatever is added: what does not composite needs no order of the faces, no k-buffer, no pre-integration.
TEST_P(PlanNeeds, OfModesWithoutAnOrderHoldNone) {
  const Mode& shown = mode(GetParam().mode);
  if (shown.gathering == Gathering::composite) {
    const auto chosen = planned(sceneOf("exact"));
    EXPECT_EQ(chosen->sort.empty(), !chosen->visibility.needsOrder);
    return;
  }
  forEachLookup([&](const std::string& lookup) {
    for (int bits = 0; bits < kKindsOfFacts; ++bits)
      for (const EffectSubset& subset : subsetsUpToPairs()) {
        const auto chosen = planned(with(sceneOf(lookup), subset), factsOf(bits));
        if (!chosen) continue;
        SCOPED_TRACE(nameOf(subset));
        EXPECT_EQ(chosen->sort, "");
        EXPECT_EQ(chosen->ordering, "");
        EXPECT_EQ(chosen->k, 0);
        EXPECT_EQ(chosen->entryTargets, 0);
        EXPECT_EQ(chosen->tableSize, 0);
        for (const LookupResource& resource : chosen->resources) EXPECT_EQ(resource.axes, 0) << resource.name;
        for (const std::string& name : contentsOf(*chosen))
          for (const char* part : {"order of", "k-buffer", "kbuffer", "HAVS_K", "ISOSURFACES"})
            EXPECT_THAT(name, Not(HasSubstr(part)));
      }
  });
}

// Where the volume is not seen, nothing of it is computed; where no lookup is used, none of its tables are.
TEST_P(PlanNeeds, HoldTablesOnlyOfWhatIsLookedUp) {
  forEachLookup([&](const std::string& lookup) {
    for (const EffectSubset& subset : subsetsUpToPairs()) {
      const auto chosen = planned(with(sceneOf(lookup), subset));
      if (!chosen) continue;
      SCOPED_TRACE(nameOf(subset));
      std::set<std::string> expected(chosen->lookup.resources.begin(), chosen->lookup.resources.end());
      if (chosen->isosurfaces) expected.insert("isosurfaces");
      std::set<std::string> found;
      for (const LookupResource& resource : chosen->resources) found.insert(resource.name);
      EXPECT_EQ(found, expected);
    }
  });
}

}  // namespace
}  // namespace havs::test
