// Fragments that write to storage buffers: when every one of them counts, and when a driver may leave some out.
#include <gtest/gtest.h>

#include "gl/full_screen.h"
#include "support/gl_test.h"

namespace havs {
namespace {

constexpr int kSize = 256;  // whole tiles of llvmpipe, where it drops what an opaque triangle hides
constexpr int kTriangles = 50;
constexpr std::uint32_t kFragments = kTriangles * kSize * kSize;

class StorageBuffer : public GlTest {
 protected:
  /// How many fragments of triangles that cover everything add 1; `output` declares and writes `colour`.
  std::uint32_t countFragments(const std::string& output, const ShaderOptions& options = {}) {
    const Texture target = Texture::image2D("target", GL_RGBA32F, kSize, kSize);
    const Framebuffer framebuffer("target", {target});
    Buffer counter("counter", sizeof(std::uint32_t));
    counter.clear();
    counter.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    const Program program =
        makeProgram(kFullScreenVertex,
                    "layout(std430, binding = 0) buffer Counter { uint counter; };\nlayout(location = 0) " + output +
                        " vec4 colour;\nvoid main() { atomicAdd(counter, 1u); colour = vec4(1.0); }",
                    options);
    framebuffer.bind();
    framebuffer.clear(0, std::array<float, 4>{});
    program.use();
    drawFullScreen(kTriangles);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    return counter.read<std::uint32_t>(1).front();
  }
};

TEST_P(StorageBuffer, EveryFragmentCountsWithTheColourMaskOff) {
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  EXPECT_EQ(countFragments("out"), kFragments);
}

TEST_P(StorageBuffer, EveryFragmentCountsWithBlending) {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  EXPECT_EQ(countFragments("out"), kFragments);
}

TEST_P(StorageBuffer, EveryFragmentCountsWithFramebufferFetch) {
  if (!device_->hasExtension(kFetch.extensions.front())) GTEST_SKIP() << "no framebuffer fetch here";
  EXPECT_EQ(countFragments("inout", kFetch), kFragments);
}

// llvmpipe 22.3 loses a quarter here. Whatever a driver drops, it adds nothing, and something is drawn.
TEST_P(StorageBuffer, HiddenFragmentsOfOpaqueTrianglesMayBeDropped) {
  const std::uint32_t counted = countFragments("out");
  EXPECT_LE(counted, kFragments);
  EXPECT_GE(counted, static_cast<std::uint32_t>(kSize * kSize));
  RecordProperty("dropped", static_cast<int>(kFragments - counted));
}

HAVS_FOR_EVERY_DEVICE(StorageBuffer);

}  // namespace
}  // namespace havs
