// What the renderer takes for granted of rasterisation. docs/llvmpipe.md tells the results.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "gl/full_screen.h"
#include "support/gl_test.h"

namespace havs {
namespace {

using testing::Each;

constexpr const char* kPositionVertex =
    "layout(location = 0) in vec3 position;\nvoid main() { gl_Position = vec4(position, 1.0); }";

class Rasteriser : public GlTest {
 protected:
  /// Draws `corners` (x, y, z in clip space, three to a triangle) and returns the red of a target of `size` x `size`.
  std::vector<float> draw(const std::vector<float>& corners, const std::string& fragment, int size) {
    const Buffer buffer = Buffer::of("corners", corners);
    VertexArray array("corners");
    array.attribute(0, buffer, 3, GL_FLOAT, 12);
    const Texture target = Texture::image2D("target", GL_RGBA32F, size, size);
    const Framebuffer framebuffer("target", {target});
    const Program program = makeProgram(kPositionVertex, fragment);
    framebuffer.bind();
    framebuffer.clear(0, std::array<float, 4>{});
    program.use();
    array.bind();
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size() / 3));
    return framebuffer.readFloats(0, GL_RED);
  }

  std::vector<float> fullScreenAt(float z) const { return {-1, -1, z, 3, -1, z, -1, 3, z}; }
};

constexpr const char* kOne = "out vec4 colour;\nvoid main() { colour = vec4(1.0); }";

TEST_P(Rasteriser, DepthClampKeepsWhatLiesBeyondTheDepthRange) {
  for (float z : {-7.0F, 7.0F}) {
    EXPECT_THAT(draw(fullScreenAt(z), kOne, 70), Each(0.0F));
    glEnable(GL_DEPTH_CLAMP);
    EXPECT_THAT(draw(fullScreenAt(z), kOne, 70), Each(1.0F));
    glDisable(GL_DEPTH_CLAMP);
  }
}

TEST_P(Rasteriser, ClipControlTurnsThePictureButNotTheFacing) {
  // Front-facing; covers the lower left half of the picture as OpenGL has it by default.
  const std::vector<float> lowerLeft = {-1, -1, 0, 1, -1, 0, -1, 1, 0};
  const std::string facing = "out vec4 colour;\nvoid main() { colour = vec4(gl_FrontFacing ? 1.0 : -1.0); }";
  const std::vector<float> bottomUp = draw(lowerLeft, facing, 64);
  glClipControl(GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  const std::vector<float> topDown = draw(lowerLeft, facing, 64);
  EXPECT_EQ(bottomUp[0], 1.0F);
  EXPECT_EQ(bottomUp[63 * 64 + 63], 0.0F);
  // Off the diagonal, where the fill rule decides, the rows come in the other order and nothing else changes.
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      if (x + y == 63) continue;
      const auto from = static_cast<std::size_t>(y * 64 + x), to = static_cast<std::size_t>((63 - y) * 64 + x);
      ASSERT_EQ(topDown[to], bottomUp[from]) << x << ", " << y;
    }
  }
}

TEST_P(Rasteriser, ClipControlMovesTheNearPlaneToZero) {
  EXPECT_THAT(draw(fullScreenAt(-0.5F), kOne, 8), Each(1.0F));
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  EXPECT_THAT(draw(fullScreenAt(-0.5F), kOne, 8), Each(0.0F));
  EXPECT_THAT(draw(fullScreenAt(0.5F), kOne, 8), Each(1.0F));
}

TEST_P(Rasteriser, PrimitiveIdCountsTrianglesWithoutAGeometryShader) {
  constexpr int kSize = 64;
  // One triangle round the centre of each pixel, row by row.
  std::vector<float> corners;
  for (int i = 0; i < kSize * kSize; ++i) {
    const float x = (static_cast<float>(i % kSize) + 0.5F) * 2 / kSize - 1;
    const float y = (static_cast<float>(i / kSize) + 0.5F) * 2 / kSize - 1;
    const float r = 0.5F / kSize;
    corners.insert(corners.end(), {x - r, y - r, 0, x + r, y - r, 0, x, y + r, 0});
  }
  std::vector<float> expected(kSize * kSize);
  std::iota(expected.begin(), expected.end(), 0.0F);
  EXPECT_EQ(draw(corners, "out vec4 colour;\nvoid main() { colour = vec4(gl_PrimitiveID); }", kSize), expected);
}

// Twice the signed area on the rasteriser's grid of 1/256 pixel, exact.
long long snappedArea(const std::array<double, 6>& pixel) {
  std::array<long long, 6> s{};
  for (std::size_t i = 0; i < 6; ++i) s[i] = std::llrint(pixel[i] * 256);
  return (s[2] - s[0]) * (s[5] - s[1]) - (s[4] - s[0]) * (s[3] - s[1]);
}

TEST_P(Rasteriser, FacingOfTinyTrianglesFollowsTheSnappedCorners) {
  constexpr int kSize = 512, kCell = 4, kCells = kSize / kCell;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> exponent(-9, 0.5), unit(-1, 1);
  std::vector<float> corners;
  std::vector<long long> areas;
  std::vector<bool> exactFront;
  for (int cell = 0; cell < kCells * kCells; ++cell) {
    // Around a pixel's centre, where small ones have a chance to be seen; the size is from 1/512 to 1.4 pixels.
    const double x = cell % kCells * kCell + 1.5, y = cell / kCells * kCell + 1.5, size = std::exp2(exponent(random));
    std::array<double, 6> pixel{};
    for (std::size_t c = 0; c < 6; ++c) {
      const auto clip = static_cast<float>((c % 2 ? y : x) + size * unit(random)) * 2 / kSize - 1;
      pixel[c] = (static_cast<double>(clip) + 1) * kSize / 2;
      corners.push_back(clip);
      if (c % 2) corners.push_back(0);
    }
    areas.push_back(snappedArea(pixel));
    exactFront.push_back((pixel[2] - pixel[0]) * (pixel[5] - pixel[1]) > (pixel[4] - pixel[0]) * (pixel[3] - pixel[1]));
  }
  const std::vector<float> drawn =
      draw(corners, "out vec4 colour;\nvoid main() { colour = vec4(gl_FrontFacing ? 1.0 : -1.0); }", kSize);
  int seen = 0, wrong = 0, unlikeExact = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const float value = drawn[static_cast<std::size_t>(y * kSize + x)];
      if (value == 0) continue;
      const auto cell = static_cast<std::size_t>(y / kCell * kCells + x / kCell);
      ++seen;
      wrong += (value > 0) != (areas[cell] > 0) || areas[cell] == 0;
      unlikeExact += (value > 0) != exactFront[cell];
    }
  }
  RecordProperty("unlike_exact_orientation", unlikeExact);
  EXPECT_GT(seen, 3000);
  EXPECT_EQ(wrong, 0);
}

// Every closed surface is entered as often as it is left, at every pixel and however thin it is.
TEST_P(Rasteriser, ClosedSurfacesAreEnteredAsOftenAsLeft) {
  constexpr int kSize = 256, kTetrahedra = 4000;
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(-1, 1), exponent(-10, 0);
  std::vector<float> corners;
  for (int i = 0; i < kTetrahedra; ++i) {
    const float size = std::exp2(exponent(random)), flat = std::exp2(3 * exponent(random));
    std::array<std::array<float, 3>, 4> p{};
    const float x = unit(random), y = unit(random), angle = 3.2F * unit(random);
    for (auto& q : p) {
      const float u = size * unit(random), v = size * flat * unit(random);
      q = {x + u * std::cos(angle) - v * std::sin(angle), y + u * std::sin(angle) + v * std::cos(angle), 0};
    }
    constexpr std::size_t kFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    for (const auto& face : kFaces) {
      for (std::size_t c : face) corners.insert(corners.end(), p[c].begin(), p[c].end());
    }
  }
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  EXPECT_THAT(draw(corners, kOne, kSize), testing::Contains(testing::Gt(10.0F)));
  EXPECT_THAT(draw(corners, "out vec4 colour;\nvoid main() { colour = vec4(gl_FrontFacing ? 1.0 : -1.0); }", kSize),
              Each(0.0F));
  glDisable(GL_BLEND);
}

HAVS_FOR_EVERY_DEVICE(Rasteriser);

}  // namespace
}  // namespace havs
