#pragma once
// What the tests of plans share: plans of scenes with effects, in every way of drawing, as sets that can be compared.
#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "render/effects.h"
#include "support/effect_subsets.h"

namespace havs::test {

/// What a plan is made of, as a set: of programs by their role and sources, with what
/// they are compiled with besides the defines of all. How fragments lie in
/// a k-buffer is not added but chosen, by what they carry.
using Contents = std::set<std::string>;

inline bool isDefined(const RenderPlan& plan, const std::string& name) {
  return std::any_of(plan.defines.begin(), plan.defines.end(), [&](const auto& define) { return define.name == name; });
}

inline Contents contentsOf(const RenderPlan& plan) {
  Contents contents;
  for (const PlanItem& item : plan.items)
    if (item.kind != PlanKind::program)
      contents.insert(std::string(nameOf(item.kind)) + ": " + item.name + " in stage " + item.stage);
  for (const PlannedProgram& program : plan.programs) {
    const std::string name = "program: " + program.role + ", " + program.vertex + ", " + program.fragment;
    contents.insert(name);
    for (const auto& [file, other] : program.options.standsFor)
      if (file == "lookup.glsl") contents.insert(name + " with " + other);
    for (const auto& [define, value] : program.options.defines)
      if (!isDefined(plan, define)) contents.insert(name + " " + define);
  }
  for (const ShaderDefine& define : plan.defines) contents.insert("define: " + define.name);
  for (const LookupResource& resource : plan.resources) contents.insert("resource: " + resource.name);
  return contents;
}

inline Contents joined(Contents all, const Contents& more) {
  all.insert(more.begin(), more.end());
  return all;
}

/// What is in one only, for messages.
inline std::string difference(const Contents& expected, const Contents& found) {
  std::string text;
  for (const std::string& name : expected)
    if (!found.contains(name)) text += "\n  missing: " + name;
  for (const std::string& name : found)
    if (!expected.contains(name)) text += "\n  not called for: " + name;
  return text;
}

inline std::map<std::string, std::size_t> bytesOf(const RenderPlan& plan) {
  std::map<std::string, std::size_t> bytes;
  for (const PlanItem& item : plan.items)
    if (item.kind != PlanKind::program) bytes[item.name] += item.bytes;
  return bytes;
}

inline SceneFacts factsOf(int bits) {
  SceneFacts facts;
  facts.cellData = (bits & 1) != 0;
  facts.opaqueSurfaces = (bits & 2) != 0;
  facts.clearCells = facts.cellsWithoutSurface = (bits & 4) != 0;
  facts.knotsInCells = (bits & 8) != 0 ? 10 : 0.5;
  facts.points = 100;
  facts.cells = 400;
  facts.faces = 900;
  return facts;
}
inline constexpr int kKindsOfFacts = 16;

/// A way of drawing; a plan that is refused is none.
struct Setting {
  std::string mode;
  bool native = false;
  std::string visibility = "kbuffer";
};

class EffectPlans : public testing::TestWithParam<Setting> {
 protected:
  /// Modes that show nothing without an effect have it always.
  Scene sceneOf(const std::string& lookup) const {
    Scene scene;
    scene.mode = GetParam().mode;
    scene.visibility = GetParam().visibility;
    scene.lookup = lookup;
    if (!mode(scene.mode).seesVolume) scene.isosurfaces = {{.value = 0.5}};
    return scene;
  }

  std::optional<RenderPlan> planned(const Scene& scene, const SceneFacts& facts = factsOf(0)) const {
    Capabilities capabilities;
    capabilities.native = GetParam().native;
    capabilities.hasExtension = [](const std::string&) { return true; };
    try {
      return plan(scene, facts, capabilities);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input) << error.what();
      return std::nullopt;
    }
  }

  /// Whether the way's fragments carry what the lookup needs.
  bool takesLookup(const std::string& name) const {
    return !usesLookup(mode(GetParam().mode)) || lookup(name).carries == Payload::scalar ||
           visibilityMethod(GetParam().visibility).carriesColors;
  }

  /// Calls test(lookup's name).
  template <class Test>
  void forEachLookup(const Test& test) const {
    for (const Lookup& row : lookups()) {
      SCOPED_TRACE(row.name);
      if (takesLookup(exampleName(row))) test(exampleName(row));
    }
  }
};

inline std::vector<Setting> settings() {
  std::vector<Setting> all;
  for (const Mode& row : modes()) {
    all.push_back({row.name, true});
    for (const VisibilityMethod& method : visibilityMethods())
      if (row.gathering == Gathering::composite || all.back().native) all.push_back({row.name, false, method.name});
  }
  return all;
}
inline std::string nameOf(const Setting& s) {
  return s.mode + "_" + (s.native ? "native" : mode(s.mode).gathering == Gathering::composite ? s.visibility : "gl");
}

}  // namespace havs::test

#define HAVS_FOR_EVERY_WAY(Suite)                                                    \
  INSTANTIATE_TEST_SUITE_P(Ways, Suite, testing::ValuesIn(::havs::test::settings()), \
                           [](const auto& test) { return ::havs::test::nameOf(test.param); })
