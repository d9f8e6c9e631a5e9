// The lookups on SIMD lanes against the same arithmetic in float, bit for bit, and against double precision.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "render/lookup_resources.h"
#include "support/lookup_in_double.h"
#include "support/temporary_folder.h"
#include "unit/render_native/shaded.h"

namespace havs::test {
namespace {

constexpr int kTableSize = 32;
constexpr std::size_t kSegments = 5000;
using F = Arithmetic<FloatLane>;

LookupScene sceneOf(const std::string& lookup, const std::string& transfer, const std::string& format = "rgba32f") {
  Scene scene;
  scene.lookup = lookup;
  scene.transferFunction = transfer;
  scene.tableSize = kTableSize;
  scene.tableFormat = format;
  return LookupScene(scene);
}

float longestOf(const LookupScene& scene) { return static_cast<float>(scene.prepared.longestEdge); }

/// What the shaders' files give as C++ over single floats; nothing for lookups that filter tables.
std::optional<F::Rgba> inFloat(const LookupScene& scene, const CurveFetch<FloatLane>& fetch, const GivenSegment& s) {
  const Lookup& row = scene.plan.lookup;
  const auto color = [&](std::array<float, 4> c) {
    return F::Rgba(c[0], c[1], c[2], c[3] * static_cast<float>(scene.prepared.curve.maximumKappa));
  };
  if (row.name == "exact") return F::exactSegment(fetch, s.front, s.back, s.length);
  if (row.name == "post") return F::trapezoidSegment(F::curveAt(fetch, s.front), F::curveAt(fetch, s.back), s.length);
  if (row.name == "integral") return F::integralSegment(fetch, s.front, s.back, s.length);
  if (row.name == "pre") return F::linearPiece(color(s.frontColor), color(s.backColor), s.length);
  if (row.name.starts_with("riemann:")) return F::riemannSegment(fetch, s.front, s.back, s.length, row.number);
  if (row.name.starts_with("riemann-linear:"))
    return F::riemannLinearSegment(fetch, s.front, s.back, s.length, row.number);
  return {};
}

TEST(NativeLookups, AreTheSharedArithmeticBitForBit) {
  std::size_t compared = 0;
  for (const Lookup& row : lookups())
    for (const char* transfer : {"viridis", "three-peaks", "shells"}) {
      const LookupScene scene = sceneOf(exampleName(row), transfer);
      const PackedCurve<float> packed = packCurve<float>(scene.prepared.curve);
      const CurveFetch<FloatLane> fetch(packed);
      const auto given = segmentsOfAllKinds(longestOf(scene), kSegments);
      const std::vector<Color> got = shaded(scene.shader(""), given);
      for (std::size_t i = 0; i < given.size(); ++i) {
        const auto expected = inFloat(scene, fetch, given[i]);
        if (!expected) break;
        ++compared;
        ASSERT_EQ(bitsOf(got[i]), bitsOf({expected->r, expected->g, expected->b, expected->a}))
            << scene.plan.lookup.name << " " << transfer << " " << given[i].front << " " << given[i].back << " "
            << given[i].length;
      }
    }
  EXPECT_EQ(compared, 6 * 3 * kSegments);
}

Rgba rgbaOf(const Color& c) { return {c[0], c[1], c[2], c[3]}; }

/// The worst difference from the row's own computation in double; of segments no longer than the table.
double worstOf(const LookupScene& scene, const LookupSetting& setting) {
  const LookupFunction expected = inDouble(scene.plan.lookup, setting);
  auto given = segmentsOfAllKinds(longestOf(scene), kSegments);
  for (GivenSegment& s : given) s.length = std::min(s.length, longestOf(scene));
  const std::vector<Color> got = shaded(scene.shader(""), given);
  double worst = 0;
  for (std::size_t i = 0; i < given.size(); ++i) {
    for (float channel : got[i]) EXPECT_TRUE(channel >= 0 && channel <= 1 + kLookupFloat) << channel;
    worst = std::max(worst, distance(rgbaOf(got[i]), expected(given[i].front, given[i].back, given[i].length)));
  }
  return worst;
}

TEST(NativeLookups, AreWhatTheyAreInDouble) {
  for (const Lookup& row : lookups()) {
    if (row.carries == Payload::color) continue;
    for (const char* transfer : {"viridis", "three-peaks", "shells"}) {
      const LookupScene scene = sceneOf(exampleName(row), transfer);
      const LookupSetting setting{scene.prepared.curve, scene.prepared.longestEdge, meanSegmentLength(scene.prepared),
                                  kTableSize};
      const double worst = worstOf(scene, setting);
      RecordProperty(row.name + " " + transfer, std::to_string(worst * 1e7) + "e-7");
      EXPECT_LE(worst, floatBoundOf(scene.plan.lookup, setting)) << row.name << " " << transfer;
    }
  }
}

// An entry is off by half a step of the format at most, and so is what is interpolated: see lookup_segments_test.cpp.
TEST(NativeLookups, TableFormatsAreRoundedToTheNearest) {
  for (const Lookup& row : lookups())
    for (const TableFormat& format : tableFormats()) {
      if (!tableOf(row)) continue;
      const LookupScene scene = sceneOf(row.name, "viridis", format.name);
      const LookupSetting setting{scene.prepared.curve, scene.prepared.longestEdge, meanSegmentLength(scene.prepared),
                                  kTableSize};
      const double deepest = scene.prepared.curve.maximumKappa * scene.prepared.longestEdge;
      const double half = halfStepOf(format) * (row.name == "2d" ? 1 + deepest : 1);
      const double worst = worstOf(scene, setting);
      EXPECT_LE(worst, floatBoundOf(scene.plan.lookup, setting) + half) << row.name << " " << format.name;
      EXPECT_GE(worst, 0.3 * halfStepOf(format)) << row.name << " does not look at its format, " << format.name;
    }
}

/// `before` as the lookup alone has it, up to where the segment first meets an opaque scalar; the surface behind it.
Rgba upToOpaque(const PreparedScene& prepared, const LookupFunction& lookUp, const GivenSegment& s) {
  const double hit = firstOpaque(prepared.curve, s.front, s.back);
  if (hit > 1) return lookUp(s.front, s.back, s.length);
  const double met = (1 - hit) * s.front + hit * s.back;
  const Rgba before = lookUp(s.front, met, hit * s.length);
  const ExtinctionCurve surfaces = withSurfaceColors(prepared.curve);
  for (const auto& [low, high] : prepared.curve.opaque) {
    if (met < low - 1e-9 || met > high + 1e-9) continue;
    const double half = 0.5 * (high - low), inside = 0x1p-22;  // opaque_surfaces.glsl
    const auto color =
        surfaces
            .at(std::clamp(double{s.front}, low + std::min(half, inside * low), high - std::min(half, inside * high)))
            .color;
    return DoubleArithmetic::compositeUnder(before, {color[0], color[1], color[2], 1});
  }
  ADD_FAILURE() << "no surface at " << met;
  return before;
}

bool endsNearABound(const PreparedScene& prepared, const GivenSegment& s) {
  for (const auto& interval : prepared.curve.opaque)
    for (double bound : interval)
      if (std::abs(s.front - bound) < 1e-6 || std::abs(s.back - bound) < 1e-6) return true;
  return false;
}

// A wide and a narrow plateau of opacity 1; colours go on across their bounds, as a cut that is rounded to
// 2^-24 reads those of either side.
constexpr const char* kSurfaces = R"({"version": 1, "domain": [0, 1], "points": [
    {"scalar": 0, "color": [0, 1, 0], "opacity": 0.1}, {"scalar": 0.3, "color": [1, 0, 0], "opacity": 0.2},
    {"scalar": 0.3, "color": [1, 0, 0], "opacity": 1}, {"scalar": 0.42, "color": [0, 0, 1], "opacity": 1},
    {"scalar": 0.42, "color": [0, 0, 1], "opacity": 0.3}, {"scalar": 0.7, "color": [1, 1, 0], "opacity": 0.2},
    {"scalar": 0.7, "color": [1, 1, 0], "opacity": 1}, {"scalar": 0.701, "color": [1, 1, 0], "opacity": 1},
    {"scalar": 0.701, "color": [1, 1, 0], "opacity": 0.1},
    {"scalar": 1, "color": [0.5, 0.5, 0.5], "opacity": 0.2}]})";

// Where an end lies within a rounding of an interval's bound, float and double may differ on whether it is met. Where
// one is met lies on the way to the back, so it is rounded to 2^-24 and the colour read there off by its slope times
// that: below 10.
TEST(NativeLookups, SegmentsEndAtOpaqueSurfaces) {
  const TemporaryFolder folder;
  const std::string transfer = folder.write("surfaces.json", kSurfaces).string();
  for (const Lookup& row : lookups()) {
    if (row.carries == Payload::color) continue;
    const LookupScene scene = sceneOf(exampleName(row), transfer);
    ASSERT_EQ(scene.prepared.curve.opaque.size(), 2U);
    const ExtinctionCurve seen = withoutOpaque(scene.prepared.curve);
    const LookupSetting setting{seen, scene.prepared.longestEdge, meanSegmentLength(scene.prepared), kTableSize};
    const LookupFunction lookUp = inDouble(scene.plan.lookup, setting);
    auto given = segmentsOfAllKinds(longestOf(scene), kSegments);
    for (GivenSegment& s : given) s.length = std::min(s.length, longestOf(scene));
    const std::vector<Color> got = shaded(scene.shader(""), given);
    double worst = 0;
    std::size_t hits = 0;
    for (std::size_t i = 0; i < given.size(); ++i) {
      if (endsNearABound(scene.prepared, given[i])) continue;
      const Rgba expected = upToOpaque(scene.prepared, lookUp, given[i]);
      hits += expected.a == 1;
      worst = std::max(worst, distance(rgbaOf(got[i]), expected));
    }
    EXPECT_GT(hits, kSegments / 10);
    RecordProperty(row.name, std::to_string(worst * 1e7) + "e-7");
    // Roundings of the way to the surface and of its colour; one more, as the interval's end is a float, too.
    EXPECT_LE(worst, floatBoundOf(scene.plan.lookup, setting) + 11 * 0x1p-24) << row.name;
  }
}

TEST(NativeLookups, CellDataHoldsAlongASegment) {
  for (const Lookup& row : lookups()) {
    LookupScene scene = sceneOf(exampleName(row), "viridis");
    auto given = segmentsOfAllKinds(longestOf(scene), 500);
    scene.plan.cellData = true;
    const std::vector<Color> asCells = shaded(scene.shader(""), given);
    scene.plan.cellData = false;
    for (GivenSegment& s : given) {
      s.back = s.front;
      s.backColor = s.frontColor;
    }
    EXPECT_EQ(shaded(scene.shader(""), given), asCells) << row.name;
  }
}

}  // namespace
}  // namespace havs::test
