// What the k-buffer asks of a driver: a fragment reads what the last fragment of its pixel wrote, exactly, in the order
// of the triangles. docs/llvmpipe.md tells the results.
#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/gtc/packing.hpp>
#include <random>

#include "gl/full_screen.h"
#include "support/gl_test.h"

namespace havs {
namespace {

constexpr int kTargets = 8;

// A step whose result depends on the order of the steps; below 2^24, so exact in float: 8191 * 5 + 4096.
float step(float value, int triangle, int target) {
  return std::fmod(value * 5.0F + static_cast<float>(triangle % 4000 + 7 * target + 1), 8191.0F);
}
constexpr const char* kStep = R"(
flat in int triangle;
float nextValue(float value, int target) {
  float sum = value * 5.0 + float(triangle % 4000 + 7 * target + 1);
  return sum - 8191.0 * floor(sum / 8191.0);
}
)";

std::string eightTargets() {
  std::string text = kStep;
  for (int t = 0; t < kTargets; ++t)
    text += "layout(location = " + std::to_string(t) + ") inout vec4 t" + std::to_string(t) + ";\n";
  text += "void main() {\n";
  for (int t = 0; t < kTargets; ++t) {
    const std::string name = "t" + std::to_string(t);
    text += "  " + name + " = vec4(nextValue(" + name + ".x, " + std::to_string(t) + "), " + name + ".xyz);\n";
  }
  return text + "}\n";
}

TEST_P(FramebufferFetch, EightFloatTargetsReadWhatTheLastTriangleOfTheDrawCallWrote) {
  constexpr int kWidth = 150, kHeight = 70, kOverlaps = 200;  // more than one tile of 64, and parts of tiles
  std::vector<Texture> textures;
  for (int t = 0; t < kTargets; ++t) textures.push_back(Texture::image2D("target", GL_RGBA32F, kWidth, kHeight));
  const Framebuffer framebuffer("eight", Framebuffer::Targets(textures.begin(), textures.end()));
  const Program program = makeProgram(kFullScreenVertex, eightTargets(), kFetch);
  framebuffer.bind();
  for (int t = 0; t < kTargets; ++t) framebuffer.clear(t, std::array<float, 4>{float(t), 0, 0, 0});
  program.use();
  drawFullScreen(kOverlaps);
  drawFullScreen(kOverlaps);
  for (int t = 0; t < kTargets; ++t) {
    std::array<float, 4> expected = {float(t), 0, 0, 0};
    for (int i = 0; i < 2 * kOverlaps; ++i) {
      expected = {step(expected[0], i % kOverlaps, t), expected[0], expected[1], expected[2]};
    }
    const std::vector<float> pixels = framebuffer.readFloats(t);
    for (std::size_t p = 0; p < pixels.size(); ++p)
      ASSERT_EQ(pixels[p], expected[p % 4]) << "target " << t << " value " << p;
  }
}

TEST_P(FramebufferFetch, OrderHoldsForMoreTrianglesThanTheDriverBinsAtOnce) {
  constexpr int kTriangles = 300000;  // llvmpipe bins at most 36 MB, a triangle takes some 200 bytes
  const Texture texture = Texture::image2D("target", GL_RGBA32F, 4, 4);
  const Framebuffer framebuffer("small", {texture});
  const Program program = makeProgram(
      kFullScreenVertex,
      std::string(kStep) + "layout(location = 0) inout vec4 t;\nvoid main() { t.x = nextValue(t.x, 0); }", kFetch);
  framebuffer.bind();
  framebuffer.clear(0, std::array<float, 4>{});
  program.use();
  drawFullScreen(kTriangles);
  float expected = 0;
  for (int i = 0; i < kTriangles; ++i) expected = step(expected, i, 0);
  EXPECT_THAT(framebuffer.readFloats(0, GL_RED), testing::Each(expected));
}

std::vector<float> randomTriangles(int count, std::mt19937& random) {
  std::uniform_real_distribution<float> position(-1.2F, 1.2F), offset(-0.4F, 0.4F);
  std::vector<float> corners;
  for (int i = 0; i < count; ++i) {
    const bool large = i % 3 == 0;
    const float x = position(random), y = position(random);
    for (int c = 0; c < 3; ++c) {
      corners.push_back(large ? position(random) : x + offset(random));
      corners.push_back(large ? position(random) : y + offset(random));
    }
  }
  return corners;
}

// The coverage of each triangle is found by drawing it alone, without fetch.
TEST_P(FramebufferFetch, OverlappingRandomTrianglesActInTheirOrder) {
  constexpr int kSize = 200, kTriangles = 120;
  std::mt19937 random(7);
  const Buffer corners = Buffer::of("corners", randomTriangles(kTriangles, random));
  VertexArray array("corners");
  array.attribute(0, corners, 2, GL_FLOAT, 8);
  const std::string vertex =
      "layout(location = 0) in vec2 position;\nflat out int triangle;\n"
      "void main() { triangle = gl_VertexID / 3; gl_Position = vec4(position, 0.0, 1.0); }";
  const Program marks = makeProgram(vertex, "out float mark;\nvoid main() { mark = 1.0; }");
  const Program steps = makeProgram(
      vertex, std::string(kStep) + "layout(location = 0) inout vec4 t;\nvoid main() { t.x = nextValue(t.x, 0); }",
      kFetch);
  array.bind();

  const Texture markTexture = Texture::image2D("marks", GL_R8, kSize, kSize);
  const Framebuffer marked("marks", {markTexture});
  std::vector<float> expected(kSize * kSize, 0.0F);
  marked.bind();
  marks.use();
  for (int i = 0; i < kTriangles; ++i) {
    marked.clear(0, std::array<float, 4>{});
    glDrawArrays(GL_TRIANGLES, 3 * i, 3);
    const std::vector<float> mark = marked.readFloats(0, GL_RED);
    for (std::size_t p = 0; p < mark.size(); ++p) {
      if (mark[p] > 0) expected[p] = step(expected[p], i, 0);
    }
  }
  const Texture texture = Texture::image2D("target", GL_RGBA32F, kSize, kSize);
  const Framebuffer framebuffer("target", {texture});
  framebuffer.bind();
  framebuffer.clear(0, std::array<float, 4>{});
  steps.use();
  glDrawArrays(GL_TRIANGLES, 0, 3 * kTriangles);
  EXPECT_EQ(framebuffer.readFloats(0, GL_RED), expected);
}

TEST_P(FramebufferFetch, DiscardLeavesEveryTargetAsItWas) {
  const Texture a = Texture::image2D("a", GL_RGBA32F, 70, 70), b = Texture::image2D("b", GL_RGBA32F, 70, 70);
  const Framebuffer framebuffer("two", {a, b});
  const Program program = makeProgram(kFullScreenVertex, std::string(kStep) + R"(
layout(location = 0) inout vec4 a;
layout(location = 1) inout vec4 b;
void main() {
  float old = b.x;
  a.x = nextValue(a.x, 0);
  b.x = nextValue(b.x, 1);
  if (mod(old + gl_FragCoord.x, 2.0) < 1.0 && triangle % 2 == 1) discard;
}
)",
                                      kFetch);
  framebuffer.bind();
  framebuffer.clear(0, std::array<float, 4>{});
  framebuffer.clear(1, std::array<float, 4>{});
  program.use();
  drawFullScreen(40);
  const std::vector<float> pixelsA = framebuffer.readFloats(0, GL_RED), pixelsB = framebuffer.readFloats(1, GL_RED);
  for (std::size_t p = 0; p < pixelsA.size(); ++p) {
    const float x = static_cast<float>(p % 70) + 0.5F;
    float expectedA = 0, expectedB = 0;
    for (int i = 0; i < 40; ++i) {
      if (std::fmod(expectedB + x, 2.0F) < 1.0F && i % 2 == 1) continue;
      expectedA = step(expectedA, i, 0);
      expectedB = step(expectedB, i, 1);
    }
    ASSERT_EQ(pixelsA[p], expectedA) << p;
    ASSERT_EQ(pixelsB[p], expectedB) << p;
  }
}

TEST_P(FramebufferFetch, TargetsOfDifferentFormatsTogether) {
  const Texture wide = Texture::image2D("wide", GL_RGBA32F, 70, 70), one = Texture::image2D("one", GL_R32F, 70, 70),
                two = Texture::image2D("two", GL_RG32F, 70, 70), half = Texture::image2D("half", GL_RGBA16F, 70, 70),
                byte = Texture::image2D("byte", GL_R8, 70, 70);
  const Framebuffer framebuffer("mixed", {wide, one, two, half, byte});
  const Program program = makeProgram(kFullScreenVertex, R"(
layout(location = 0) inout vec4 wide;
layout(location = 1) inout float one;
layout(location = 2) inout vec2 two;
layout(location = 3) inout vec4 half_;
layout(location = 4) inout float byte_;
void main() {
  wide += vec4(1.0, 2.0, 3.0, 4.0);
  one += 1.5;
  two += vec2(1.0, -1.0);
  half_ += vec4(0.5);
  byte_ += 1.0 / 255.0;
}
)",
                                      kFetch);
  framebuffer.bind();
  for (int t = 0; t < 5; ++t) framebuffer.clear(t, std::array<float, 4>{});
  program.use();
  drawFullScreen(100);
  EXPECT_THAT(framebuffer.readFloats(0, GL_RED), testing::Each(100.0F));
  EXPECT_THAT(framebuffer.readFloats(1, GL_RED), testing::Each(150.0F));
  EXPECT_THAT(framebuffer.readFloats(2, GL_RED), testing::Each(100.0F));
  EXPECT_THAT(framebuffer.readFloats(3, GL_RED), testing::Each(50.0F));
  EXPECT_THAT(framebuffer.readFloats(4, GL_RED), testing::Each(testing::FloatEq(100.0F / 255.0F)));
}

TEST_P(FramebufferFetch, IntegerTargets) {
  const Texture texture = Texture::image2D("integers", GL_RGBA32UI, 70, 70);
  const Framebuffer framebuffer("integers", {texture});
  const Program program = makeProgram(kFullScreenVertex, R"(
layout(location = 0) inout uvec4 t;
flat in int triangle;
void main() { t = uvec4(t.x * 1664525u + uint(triangle), t.x, t.y ^ 0x80000000u, t.w + 1u); }
)",
                                      kFetch);
  framebuffer.bind();
  framebuffer.clear(0, std::array<std::uint32_t, 4>{1, 0, 0, 0xfffffff0U});
  program.use();
  drawFullScreen(40);
  std::array<std::uint32_t, 4> expected = {1, 0, 0, 0xfffffff0U};
  for (std::uint32_t i = 0; i < 40; ++i) {
    expected = {expected[0] * 1664525U + i, expected[0], expected[1] ^ 0x80000000U, expected[3] + 1};
  }
  const std::vector<std::uint32_t> pixels = framebuffer.readUints(0);
  for (std::size_t p = 0; p < pixels.size(); ++p) ASSERT_EQ(pixels[p], expected[p % 4]) << p;
}

TEST_P(FramebufferFetch, IntegerTargetsOf16Bits) {
  std::vector<Texture> textures;
  for (int i = 0; i < 8; ++i) textures.push_back(Texture::image2D("halves", GL_RGBA16UI, 70, 70));
  const Framebuffer framebuffer("halves", Framebuffer::Targets(textures.begin(), textures.end()));
  const Program program = makeProgram(kFullScreenVertex, R"(
layout(location = 0) inout uvec4 first;
layout(location = 1) inout uvec4 others[7];
flat in int triangle;
void main() {
  first = uvec4(first.x * 25173u + uint(triangle), first.x, first.y ^ 0x8000u, first.w + 1u) & 0xffffu;
  for (int i = 0; i < 7; ++i) others[i] = (others[i] + first + uint(i)) & 0xffffu;
}
)",
                                      kFetch);
  framebuffer.bind();
  for (int t = 0; t < 8; ++t) framebuffer.clear(t, std::array<std::uint32_t, 4>{1, 0, 0, 0xfff0U});
  program.use();
  drawFullScreen(40);
  std::array<std::uint32_t, 4> expected = {1, 0, 0, 0xfff0U}, last = expected;
  for (std::uint32_t i = 0; i < 40; ++i) {
    expected = {(expected[0] * 25173U + i) & 0xffffU, expected[0], expected[1] ^ 0x8000U, (expected[3] + 1) & 0xffffU};
    for (std::size_t c = 0; c < 4; ++c) last[c] = (last[c] + expected[c] + 6) & 0xffffU;
  }
  const std::vector<std::uint32_t> pixels = framebuffer.readUints(0), ends = framebuffer.readUints(7);
  for (std::size_t p = 0; p < pixels.size(); ++p) {
    ASSERT_EQ(pixels[p], expected[p % 4]) << p;
    ASSERT_EQ(ends[p], last[p % 4]) << p;
  }
}

// What the k-buffer in half floats relies on: a number that a half holds comes back as it was, whatever the rounding.
TEST_P(FramebufferFetch, HalvesOfNumbersThatFitAreExact) {
  const Texture target = Texture::image2D("out", GL_RGBA32UI, 256, 256);
  const Framebuffer framebuffer("out", {target});
  const Program program = makeProgram(kFullScreenVertex, R"(
layout(location = 0) out uvec4 result;
void main() {
  uint bits = uint(gl_FragCoord.y) * 256u + uint(gl_FragCoord.x);
  float number = unpackHalf2x16(bits).x;
  result = uvec4(packHalf2x16(vec2(number, 0.0)), packHalf2x16(vec2(0.0, number)) >> 16, floatBitsToUint(number), bits);
}
)");
  framebuffer.bind();
  program.use();
  drawFullScreen(1);
  const std::vector<std::uint32_t> pixels = framebuffer.readUints(0);
  for (std::size_t p = 0; p < pixels.size(); p += 4) {
    const std::uint32_t bits = pixels[p + 3];
    const bool finite = (bits & 0x7c00u) != 0x7c00u;
    if (!finite) continue;
    ASSERT_EQ(pixels[p], bits);
    ASSERT_EQ(pixels[p + 1], bits);
    ASSERT_EQ(std::bit_cast<float>(pixels[p + 2]), glm::unpackHalf1x16(static_cast<glm::uint16>(bits))) << bits;
  }
}

HAVS_FOR_EVERY_DEVICE(FramebufferFetch);

}  // namespace
}  // namespace havs
