// Which bits of a float come through the k-buffer's targets: the renderer packs marks into floats.
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include "gl/full_screen.h"
#include "support/gl_test.h"

namespace havs {
namespace {

// Zero, least normal, greatest, the k-buffer's empty distance -3e38; denormals; infinities; quiet and signalling NaN.
constexpr std::uint32_t kSpecial[] = {0x00000000U, 0x80000000U, 0x00800000U, 0x7f7fffffU, 0xff61b1e6U,
                                      0x00000001U, 0x807fffffU, 0x7f800000U, 0xff800000U, 0x7fc00000U,
                                      0xffc12345U, 0x7f800001U, 0xffa00000U};
constexpr int kPatterns = 4096;

bool isDenormal(std::uint32_t bits) { return (bits & 0x7f800000U) == 0 && (bits & 0x007fffffU) != 0; }
bool isFiniteNormal(std::uint32_t bits) { return !isDenormal(bits) && (bits & 0x7f800000U) != 0x7f800000U; }

class FloatBits : public FramebufferFetch {
 protected:
  FloatBits() : patterns_(std::begin(kSpecial), std::end(kSpecial)) {
    std::mt19937 random(3);
    while (patterns_.size() < kPatterns) patterns_.push_back(random());
  }

  /// Draws `count` triangles one over the other into a row of pixels, one for each pattern; pattern() in the fragment
  /// shader is the pixel's. Returns the bits of the target.
  std::vector<std::uint32_t> draw(const std::string& fragment, int count) {
    const Buffer buffer = Buffer::of("patterns", patterns_);
    const Texture patterns = Texture::overBuffer("patterns", GL_R32UI, buffer);
    const Texture target = Texture::image2D("target", GL_RGBA32F, kPatterns, 1);
    const Framebuffer framebuffer("target", {target});
    const Program program = makeProgram(kFullScreenVertex, R"(
layout(binding = 0) uniform usamplerBuffer patterns;
layout(location = 0) inout vec4 target;
flat in int triangle;
float pattern() { return uintBitsToFloat(texelFetch(patterns, int(gl_FragCoord.x)).x); }
)" + fragment,
                                        kFetch);
    framebuffer.bind();
    framebuffer.clear(0, std::array<float, 4>{});
    patterns.bind(0);
    program.use();
    drawFullScreen(count);
    return bitsOf(framebuffer.readFloats(0, GL_RED));
  }

  /// Finite normal numbers must come through everywhere; llvmpipe passes all of them.
  void expectUnchanged(const std::vector<std::uint32_t>& got) const {
    const bool all = device_->renderer().find("llvmpipe") != std::string::npos;
    for (std::size_t i = 0; i < patterns_.size(); ++i) {
      if (all || isFiniteNormal(patterns_[i])) {
        ASSERT_EQ(got[i], patterns_[i]) << std::hex << patterns_[i] << " became " << got[i];
      }
    }
  }

  static std::vector<std::uint32_t> bitsOf(const std::vector<float>& values) {
    std::vector<std::uint32_t> bits;
    for (float value : values) bits.push_back(std::bit_cast<std::uint32_t>(value));
    return bits;
  }

  std::vector<std::uint32_t> patterns_;
};

TEST_P(FloatBits, SurviveStoring) { expectUnchanged(draw("void main() { target = vec4(pattern()); }", 1)); }

TEST_P(FloatBits, SurviveFetchAndStoreAgain) {
  // From component to component, so that the store is none that the compiler leaves out.
  expectUnchanged(draw("void main() { target = triangle == 0 ? vec4(pattern()) : target.wxyz; }", 21));
}

TEST_P(FloatBits, SurviveSelection) {
  expectUnchanged(draw("void main() { target = vec4(mix(target.x, pattern(), triangle == 0)); }", 5));
}

TEST_P(FloatBits, SurviveAFlatAttribute) {
  const Buffer buffer = Buffer::of("patterns", patterns_);
  VertexArray array("patterns");
  array.attribute(0, buffer, 1, GL_FLOAT, 4);
  const Texture target = Texture::image2D("target", GL_R32F, kPatterns, 1);
  const Framebuffer framebuffer("target", {target});
  const Program program = makeProgram(R"(
layout(location = 0) in float bits;
flat out float pattern;
void main() {
  pattern = bits;
  gl_Position = vec4((float(gl_VertexID) + 0.5) / 2048.0 - 1.0, 0.0, 0.0, 1.0);
}
)",
                                      "flat in float pattern;\nout float target;\nvoid main() { target = pattern; }");
  framebuffer.bind();
  framebuffer.clear(0, std::array<float, 4>{});
  program.use();
  array.bind();
  glDrawArrays(GL_POINTS, 0, kPatterns);
  expectUnchanged(bitsOf(framebuffer.readFloats(0, GL_RED)));
}

TEST_P(FloatBits, SurviveClearing) {
  const Texture target = Texture::image2D("target", GL_RGBA32F, 70, 70);
  const Framebuffer framebuffer("target", {target});
  const bool all = device_->renderer().find("llvmpipe") != std::string::npos;
  for (std::uint32_t bits : kSpecial) {
    if (!all && !isFiniteNormal(bits)) continue;
    framebuffer.clear(0, std::array<float, 4>{std::bit_cast<float>(bits), 0, 0, 0});
    for (std::uint32_t got : bitsOf(framebuffer.readFloats(0, GL_RED))) ASSERT_EQ(got, bits) << std::hex << bits;
  }
}

TEST_P(FloatBits, ArithmeticMayFlushDenormalsAndQuietNaN) {
  const std::vector<std::uint32_t> got =
      draw("uniform float one = 1.0;\nvoid main() { target = vec4(pattern() * one); }", 1);
  int flushed = 0;
  for (std::size_t i = 0; i < patterns_.size(); ++i) {
    const auto value = std::bit_cast<float>(patterns_[i]);
    if (isDenormal(patterns_[i])) {
      EXPECT_TRUE(got[i] == patterns_[i] || got[i] == (patterns_[i] & 0x80000000U)) << std::hex << patterns_[i];
      flushed += got[i] != patterns_[i];
    } else if (std::isnan(value)) {
      EXPECT_TRUE(std::isnan(std::bit_cast<float>(got[i]))) << std::hex << patterns_[i];
    } else {
      EXPECT_EQ(got[i], patterns_[i]);
    }
  }
  RecordProperty("flushed_denormals", flushed);
}

HAVS_FOR_EVERY_DEVICE(FloatBits);

}  // namespace
}  // namespace havs
