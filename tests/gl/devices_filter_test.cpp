// How exactly textures are filtered: the look-up tables of the renderer stand on it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "gl/full_screen.h"
#include "support/gl_test.h"

namespace havs {
namespace {

constexpr int kTable = 16, kSamples = 64;

double trilinear(const std::vector<float>& table, const std::array<double, 3>& texel) {
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::size_t index = 0, stride = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double low = std::floor(texel[axis]), t = texel[axis] - low;
      const bool high = (corner >> axis & 1) != 0;
      weight *= high ? t : 1 - t;
      index += static_cast<std::size_t>(std::clamp(low + high, 0.0, kTable - 1.0)) * stride;
      stride *= kTable;
    }
    sum += weight * static_cast<double>(table[index * 4]);
  }
  return sum;
}

class Filter : public GlTest {
 protected:
  /// The largest error of the linear filter over a table of random multiples of 1 / steps in [0, 1], held as `format`.
  double largestError(GLenum format, unsigned steps = 255) {
    std::mt19937 random(1);
    std::vector<float> table(kTable * kTable * kTable * 4);
    for (float& value : table) value = static_cast<float>(random() % 256) / static_cast<float>(steps);
    Texture texture = Texture::image3D("table", format, kTable, kTable, kTable);
    texture.upload(GL_RGBA, table);
    texture.filter(GL_LINEAR);
    texture.bind(0);
    const Texture target = Texture::image2D("target", GL_RGBA32F, kSamples, kSamples);
    const Framebuffer framebuffer("target", {target});
    // Powers of two only, so that the coordinates are exact: texel coordinates in steps of 1/256.
    const Program program = makeProgram(kFullScreenVertex, R"(
layout(binding = 0) uniform sampler3D table;
out vec4 colour;
void main() {
  vec2 p = floor(gl_FragCoord.xy);
  vec3 texel = vec3(p * 57.0, p.x * 13.0 + p.y * 41.0) / 256.0;
  colour = texture(table, (texel + 0.5) / 16.0);
}
)");
    framebuffer.bind();
    program.use();
    drawFullScreen(1);
    const std::vector<float> got = framebuffer.readFloats(0, GL_RED);
    double largest = 0;
    for (int y = 0; y < kSamples; ++y) {
      for (int x = 0; x < kSamples; ++x) {
        const double expected = trilinear(table, {x * 57 / 256.0, y * 57 / 256.0, (x * 13 + y * 41) / 256.0});
        largest = std::max(largest,
                           std::abs(static_cast<double>(got[static_cast<std::size_t>(y * kSamples + x)]) - expected));
      }
    }
    return largest;
  }
};

// Seven interpolations in float between values below 1, each within 2^-24, and coordinates within 16 * 2^-24.
TEST_P(Filter, FloatTablesAreFilteredInFloatOnLlvmpipe) {
  if (device_->renderer().find("llvmpipe") == std::string::npos) GTEST_SKIP() << "GPUs filter with 8-bit weights";
  EXPECT_LE(largestError(GL_RGBA32F), 2e-6);
}

// Multiples of 1/255 are exact in 16 bits, those of 1/256 in half floats. What is not is cut off by llvmpipe as it is
// uploaded, by up to a step of 2^-11: tables are rounded before.
TEST_P(Filter, TablesOf16BitsAreFilteredInFloatOnLlvmpipe) {
  if (device_->renderer().find("llvmpipe") == std::string::npos) GTEST_SKIP() << "GPUs filter with 8-bit weights";
  EXPECT_LE(largestError(GL_RGBA16), 2e-6);
  EXPECT_LE(largestError(GL_RGBA16F, 256), 2e-6);
  EXPECT_LE(largestError(GL_RGBA16F), 2e-6 + 0x1p-11);
  EXPECT_GT(largestError(GL_RGBA16F), 2e-6 + 0x1p-12);
}

// Weights of 8 bits at the least: three axes, half a step of 1/256 each, and rounding of the values to 8 bits.
TEST_P(Filter, ByteTablesAreFilteredWithinEightBits) {
  const double error = largestError(GL_RGBA8);
  EXPECT_LE(error, 3.0 / 256 + 3.0 / 255);
  RecordProperty("largest_error_times_1e6", static_cast<int>(1e6 * error));
}

HAVS_FOR_EVERY_DEVICE(Filter);

}  // namespace
}  // namespace havs
