// Segments cut at isosurfaces on SIMD lanes: against the definition in double, surface by surface; and the same bits by
// every instruction set.
#include <gtest/gtest.h>

#include <algorithm>

#include "render/lookup_resources.h"
#include "support/lookup_in_double.h"
#include "unit/render_native/shaded.h"

namespace havs::test {
namespace {

constexpr int kTableSize = 32;
constexpr std::size_t kSegments = 5000;

/// Two of them at ends of the grid of segmentsOfAllKinds, two close together, two at one value.
Scene sceneOf(const std::string& lookup, const std::string& mode = "volume", double opacity = 0.3) {
  Scene scene;
  scene.lookup = lookup;
  scene.mode = mode;
  scene.transferFunction = "three-peaks";
  scene.tableSize = kTableSize;
  scene.isosurfaces = {{0.8, havs::Color{0, 1, 1}, opacity},
                       {0.3, havs::Color{1, 0, 0}, 0.6},
                       {0.3001, havs::Color{0, 1, 0}, 0.5},
                       {0.5, {}, opacity},
                       {0.5, havs::Color{1, 1, 0}, 0.25}};
  return scene;
}

float longestOf(const LookupScene& scene) { return static_cast<float>(scene.prepared.longestEdge); }
Rgba rgbaOf(const std::array<float, 4>& c) { return {c[0], c[1], c[2], c[3]}; }

struct Crossing {
  double share, value;
  Rgba color;  // premultiplied
};

/// By the definition, one surface after another; `value` as the shaders have it.
std::vector<Crossing> crossingsOf(const PreparedScene& prepared, const GivenSegment& s) {
  std::vector<Crossing> all;
  for (const ShownIsosurface& surface : prepared.isosurfaces) {
    const float value = static_cast<float>(surface.scalar);
    const bool rises = s.front < value && value <= s.back, falls = s.back < value && value <= s.front;
    const double a = surface.opacity;
    if (rises || falls)
      all.push_back({(value - double{s.front}) / (double{s.back} - s.front),
                     value,
                     {a * surface.color[0], a * surface.color[1], a * surface.color[2], a}});
  }
  if (s.back < s.front) std::reverse(all.begin(), all.end());  // of one value: the other side comes first
  return all;
}

Rgba expectedOf(const PreparedScene& prepared, const LookupFunction& lookUp, const GivenSegment& s, bool volume) {
  using A = DoubleArithmetic;
  Rgba sum(0, 0, 0, 0);
  double from = s.front, begin = 0;
  for (const Crossing& c : crossingsOf(prepared, s)) {
    if (volume) sum = A::compositeUnder(sum, lookUp(from, c.value, (c.share - begin) * s.length));
    sum = A::compositeUnder(sum, c.color);
    from = c.value;
    begin = c.share;
  }
  return volume ? A::compositeUnder(sum, lookUp(from, s.back, (1 - begin) * s.length)) : sum;
}

std::vector<GivenSegment> segmentsWithinTable(const LookupScene& scene) {
  auto given = segmentsOfAllKinds(longestOf(scene), kSegments);
  for (GivenSegment& s : given) s.length = std::min(s.length, longestOf(scene));
  return given;
}

// Which surfaces are crossed is decided by comparisons of the very floats, so that no segment is left out here. Shares
// of the way are rounded to 2^-24 of 1, and lengths of parts with them, which extinction magnifies: there are up to six
// parts.
TEST(IsosurfaceSegments, AreCutAsTheDefinitionSays) {
  for (const Lookup& row : lookups()) {
    if (row.carries == Payload::color) continue;
    const LookupScene scene = LookupScene(sceneOf(exampleName(row)));
    const LookupSetting setting{scene.prepared.curve, scene.prepared.longestEdge, meanSegmentLength(scene.prepared),
                                kTableSize};
    const LookupFunction lookUp = inDouble(scene.plan.lookup, setting);
    const auto given = segmentsWithinTable(scene);
    const auto got = shaded(scene.shader(""), given);
    double worst = 0;
    std::size_t crossings = 0;
    for (std::size_t i = 0; i < given.size(); ++i) {
      crossings += crossingsOf(scene.prepared, given[i]).size();
      worst = std::max(worst, distance(rgbaOf(got[i]), expectedOf(scene.prepared, lookUp, given[i], true)));
    }
    EXPECT_GT(crossings, kSegments);
    RecordProperty(row.name, std::to_string(worst * 1e7) + "e-7");
    const double deepest = scene.prepared.curve.maximumKappa * scene.prepared.longestEdge;
    EXPECT_LE(worst, 6 * (floatBoundOf(scene.plan.lookup, setting) + deepest * 0x1p-23)) << row.name;
  }
}

// Five products and sums of numbers up to 1.
TEST(IsosurfaceSegments, AloneAreTheSurfacesOfTheDefinition) {
  const LookupScene scene = LookupScene(sceneOf("exact", "isosurfaces"));
  const auto given = segmentsOfAllKinds(longestOf(scene), kSegments);
  const auto got = shaded(scene.shader(""), given);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Rgba expected = expectedOf(scene.prepared, {}, given[i], false);
    ASSERT_LE(distance(rgbaOf(got[i]), expected), 10 * 0x1p-24) << given[i].front << " to " << given[i].back;
  }
}

// Also where the segments that meet do so at a surface's very value, and wherever they turn.
TEST(IsosurfaceSegments, AWayOfManySegmentsCrossesEachSurfaceAsOftenAsItChangesSides) {
  Scene asked = sceneOf("exact", "isosurfaces");
  asked.isosurfaces = {{0.5, havs::Color{1, 1, 1}, 0.5}};
  const LookupScene scene = LookupScene(asked);
  std::mt19937 random(11);
  std::size_t crossed = 0;
  for (int round = 0; round < 500; ++round) {
    std::vector<GivenSegment> way;
    float scalar = 0.25F * static_cast<float>(random() % 5);
    const bool startsBelow = scalar < 0.5F;
    std::size_t sides = 0;
    bool below = startsBelow;
    for (int i = 0; i < 40; ++i) {
      const float next = 0.25F * static_cast<float>(random() % 5);  // a third of them 0.5 itself
      way.push_back({scalar, next, 0.1F, {}, {}});
      sides += (next < 0.5F) != below;
      below = next < 0.5F;
      scalar = next;
    }
    std::size_t counted = 0;
    for (const auto& color : shaded(scene.shader(""), way)) counted += color[3] == 0.5F;
    ASSERT_EQ(counted, sides);
    crossed += sides;
  }
  EXPECT_GT(crossed, 5000u);
}

TEST(IsosurfaceSegments, WithoutACrossingAreWhatTheyAreWithoutSurfaces) {
  for (const Lookup& row : lookups()) {
    if (row.carries == Payload::color) continue;
    LookupScene scene = LookupScene(sceneOf(exampleName(row)));
    auto given = segmentsOfAllKinds(longestOf(scene), kSegments);
    std::erase_if(given, [&](const GivenSegment& s) { return !crossingsOf(scene.prepared, s).empty(); });
    const auto with = shaded(scene.shader(""), given);
    scene.plan.isosurfaces = false;
    EXPECT_EQ(with, shaded(scene.shader(""), given)) << row.name;
    EXPECT_GT(given.size(), kSegments / 10);
  }
}

TEST(IsosurfaceSegments, EveryInstructionSetGivesTheSameBitsWhateverTheNeighbours) {
  for (const double opacity : {0.3, 1.0})
    for (const Lookup& row : lookups()) {
      if (row.carries == Payload::color) continue;
      const LookupScene scene = LookupScene(sceneOf(exampleName(row), "volume", opacity));
      const auto given = segmentsOfAllKinds(longestOf(scene), kSegments);
      const auto expected = shaded(scene.shader("scalar"), given);
      for (const std::string& name : instructionSetsHere())
        EXPECT_EQ(shaded(scene.shader(name), given), expected) << row.name << " " << name;
      EXPECT_EQ(shaded(scene.shader(""), given, 7), expected) << row.name << ", seven at a time";
    }
}

}  // namespace
}  // namespace havs::test
