// lookUp() of every row, called for given segments by a program of its own, on every device: against the same lookup in
// double, and `exact` against integrateSegment.
#include <gtest/gtest.h>

#include <random>

#include "gl/drawing.h"
#include "gl/full_screen.h"
#include "render/gl/lookup_textures.h"
#include "support/gl_test.h"
#include "support/lookup_in_double.h"

namespace havs::test {
namespace {

constexpr int kSide = 64;  // of the target: 4096 segments
constexpr int kTableSize = 32;
constexpr GLuint kSegmentsUnit = 15;

constexpr const char* kFragment = R"(
#include "core/language.glsl"
#include "payload.glsl"
#include "core/kbuffer.glsl"
#include "core/compositing.glsl"
#include "lookup.glsl"
uniform sampler2D segments;
out vec4 color;
void main() {
  vec4 given = texelFetch(segments, ivec2(gl_FragCoord.xy), 0);
  Segment segment;
  segment.scalarFront = given.x;
  segment.scalarBack = given.y;
  segment.length = given.z;
  segment.visible = true;
  color = lookUp(segment);
}
)";

/// (front, back, length, unused): a grid of scalars and lengths, then random segments, many of them short in the
/// scalar.
std::vector<float> segments(double longest) {
  std::vector<float> list;
  const auto add = [&](float front, float back, double length) {
    list.insert(list.end(), {front, back, static_cast<float>(length), 0});
  };
  for (int f = 0; f <= 10; ++f)
    for (int b = 0; b <= 10; ++b)
      for (double part : {0.0, 1e-4, 0.1, 0.5, 1.0})
        add(static_cast<float>(f) / 10, static_cast<float>(b) / 10, part * longest);
  std::mt19937 random(4);
  std::uniform_real_distribution<float> unit(0, 1);
  while (list.size() < 4 * kSide * kSide) {
    const float front = unit(random);
    const float span = random() % 2 ? 1.0F : 0.02F;
    add(front, std::clamp(front + span * (2 * unit(random) - 1), 0.0F, 1.0F), longest * unit(random));
  }
  return list;
}

/// lookUp() of each segment on the current device.
std::vector<float> lookedUp(const PreparedScene& prepared, const RenderPlan& plan, const std::vector<float>& given) {
  ShaderOptions options{{{"HAVS_K", "1"}}, {}, {{"lookup.glsl", plan.lookup.shader}}};
  for (const ShaderDefine& define : plan.defines) options.defines[define.name] = define.value;
  const Program program = makeProgram(kFullScreenVertex, kFragment, options);
  Texture source = Texture::image2D("segments", GL_RGBA32F, kSide, kSide);
  source.upload(GL_RGBA, std::span<const float>(given));
  source.bind(kSegmentsUnit);
  const Texture target = Texture::image2D("target", GL_RGBA32F, kSide, kSide);
  const Framebuffer framebuffer("target", {target});
  const LookupTextures textures(prepared, plan, {});
  framebuffer.bind();
  glViewport(0, 0, kSide, kSide);
  program.use();
  program.set("segments", static_cast<int>(kSegmentsUnit));
  textures.bind(program);
  drawFullScreen(1);
  return framebuffer.readFloats(0, GL_RGBA);
}

class LookupSegments : public GlTest {
 protected:
  /// The worst error of a row, of its own computation in double.
  double worstOf(const std::string& lookupName, const std::string& transfer, double* bound = nullptr,
                 const std::string& format = "rgba32f", double* deepest = nullptr) {
    Scene scene;
    scene.tableFormat = format;
    scene.transferFunction = transfer;
    scene.lookup = lookupName;
    scene.tableSize = kTableSize;
    TetMesh mesh = box(2);
    auto values = constantField(mesh.points, 0.5);
    StageTimes stages;
    const PreparedScene prepared = prepareScene(scene, withPointField(std::move(mesh), std::move(values)), stages);
    const ExtinctionCurve curve = withoutOpaque(prepared.curve);
    Capabilities capabilities = capabilitiesOf(*device_);
    capabilities.hasExtension = [](const std::string&) { return true; };  // nothing is drawn by the method
    const RenderPlan chosen = plan(scene, prepared.facts(), capabilities);
    const LookupSetting setting{curve, prepared.longestEdge, meanSegmentLength(prepared), kTableSize};
    const LookupFunction expected = inDouble(chosen.lookup, setting);
    if (bound) *bound = floatBoundOf(chosen.lookup, setting);
    if (deepest) *deepest = curve.maximumKappa * prepared.longestEdge;
    const std::vector<float> given = segments(prepared.longestEdge);
    const std::vector<float> got = lookedUp(prepared, chosen, given);
    double worst = 0;
    for (std::size_t i = 0; i < given.size(); i += 4) {
      const Rgba color(got[i], got[i + 1], got[i + 2], got[i + 3]);
      for (double channel : {color.r, color.g, color.b, color.a}) {
        EXPECT_TRUE(channel >= 0 && channel <= 1 + kLookupFloat)
            << lookupName << " " << given[i] << " " << given[i + 1];
      }
      worst = std::max(worst, distance(color, expected(given[i], given[i + 1], given[i + 2])));
    }
    return worst;
  }
};

TEST_P(LookupSegments, EveryRowIsWhatItIsInDouble) {
  for (const Lookup& row : lookups()) {
    if (row.carries == Payload::color) continue;  // its own tests: lookup_pre_test.cpp
    for (const char* transfer : {"viridis", "three-peaks", "shells"}) {
      double bound = 0;
      const double worst = worstOf(exampleName(row), transfer, &bound);
      RecordProperty(row.name + " " + transfer, std::to_string(worst * 1e7) + "e-7");
      EXPECT_LE(worst, bound) << row.name << " " << transfer;
    }
  }
}

// An entry is off by half a step of the format at most, and so is what is interpolated. The colour of the rows of mean
// colours is such a mixture times an opacity of at most 1; the opacity of `2d` has its extinction, as a part of the
// greatest one, off by that much times the length.
TEST_P(LookupSegments, EveryFormatIsRoundedToTheNearest) {
  for (const Lookup& row : lookups())
    for (const TableFormat& format : tableFormats()) {
      if (!tableOf(row)) continue;
      double bound = 0, deepest = 0;
      const double worst = worstOf(row.name, "viridis", &bound, format.name, &deepest);
      EXPECT_LE(worst, bound + halfStepOf(format) * (row.name == "2d" ? 1 + deepest : 1))
          << row.name << " " << format.name;
    }
}

// On both sides of the steps, on them, and at both ends.
TEST_P(LookupSegments, StepsAreNotSmeared) {
  const TransferFile transfer(R"({"version": 1, "opacity": "extinction", "unit_length": 1, "domain": [0, 1], "points": [
    {"scalar": 0, "color": [0, 1, 0], "opacity": 2}, {"scalar": 0.3, "color": [0, 0, 1], "opacity": 1},
    {"scalar": 0.3, "color": [1, 0, 0], "opacity": 9}, {"scalar": 0.5, "color": [1, 0, 0], "opacity": 9},
    {"scalar": 0.5, "color": [1, 1, 1], "opacity": 0}, {"scalar": 1, "color": [1, 1, 1], "opacity": 3},
    {"scalar": 1, "color": [0, 0, 0], "opacity": 5}]})");
  for (const char* name : {"exact", "post", "integral"})
    EXPECT_LE(worstOf(name, transfer.path()), kLookupFloat) << name;
}

HAVS_FOR_EVERY_DEVICE(LookupSegments);

}  // namespace
}  // namespace havs::test
