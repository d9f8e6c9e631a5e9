#include <gmock/gmock.h>

#include <type_traits>
#include <utility>

#include "core/error.h"
#include "gl/full_screen.h"
#include "support/gl_test.h"

namespace havs {
namespace {

using testing::AllOf;
using testing::Each;
using testing::HasSubstr;

static_assert(std::is_nothrow_move_constructible_v<Buffer> && !std::is_copy_constructible_v<Buffer>);
static_assert(std::is_nothrow_move_constructible_v<VertexArray> && !std::is_copy_constructible_v<VertexArray>);
static_assert(std::is_nothrow_move_constructible_v<Texture> && !std::is_copy_constructible_v<Texture>);
static_assert(std::is_nothrow_move_constructible_v<Framebuffer> && !std::is_copy_constructible_v<Framebuffer>);
static_assert(std::is_nothrow_move_constructible_v<Program> && !std::is_copy_constructible_v<Program>);

class Objects : public GlTest {};

template <class Action>
std::string errorOf(Action action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::running);
    return error.what();
  }
  return "no error";
}

std::string labelOf(GLenum type, GLuint id) {
  char text[256] = {};
  glGetObjectLabel(type, id, sizeof text, nullptr, text);
  return text;
}

TEST_P(Objects, AreDeletedOnceByTheirLastOwner) {
  GLuint id = 0;
  {
    Buffer first("first", 16);
    id = first.id();
    Buffer second = std::move(first);
    EXPECT_EQ(first.id(), 0U);  // NOLINT: what is left after a move is what is tested
    EXPECT_EQ(second.id(), id);
    Buffer third("third", 8);
    third = std::move(second);
    EXPECT_EQ(third.id(), id);
    EXPECT_EQ(third.bytes(), 16U);
    EXPECT_TRUE(glIsBuffer(id));
  }
  EXPECT_FALSE(glIsBuffer(id));
}

TEST_P(Objects, CarryTheirLabels) {
  const Buffer buffer("the buffer", 4);
  EXPECT_EQ(labelOf(GL_BUFFER, buffer.id()), "the buffer");
  const Texture texture = Texture::image3D("the texture", GL_RGBA32F, 2, 2, 2);
  EXPECT_EQ(labelOf(GL_TEXTURE, texture.id()), "the texture");
  const Buffer longest(std::string(1000, 'x'), 4);
  EXPECT_EQ(labelOf(GL_BUFFER, longest.id()), std::string(255, 'x'));
}

TEST_P(Objects, BufferKeepsWhatIsUploadedInPart) {
  Buffer buffer = Buffer::of("numbers", std::vector<int>{1, 2, 3, 4});
  const std::vector<int> middle = {7, 8};
  buffer.upload(std::span<const int>(middle), 4);
  EXPECT_EQ(buffer.read<int>(4), (std::vector<int>{1, 7, 8, 4}));
  EXPECT_EQ(buffer.read<int>(2, 8), (std::vector<int>{8, 4}));
  buffer.clear();
  EXPECT_THAT(buffer.read<int>(4), Each(0));
  EXPECT_THAT(errorOf([&] { buffer.upload(std::span<const int>(middle), 12); }), HasSubstr("outside"));
  EXPECT_THAT(errorOf([&] { buffer.read<int>(5); }), HasSubstr("outside"));
}

TEST_P(Objects, EmptyBufferIsLegal) {
  Buffer buffer = Buffer::of("nothing", std::vector<float>{});
  EXPECT_EQ(buffer.bytes(), 0U);
  EXPECT_TRUE(buffer.read<float>(0).empty());
}

TEST_P(Objects, MoreMemoryThanThereIsIsAnError) {
  EXPECT_THAT(errorOf([] { Buffer("huge", std::size_t(1) << 62); }), HasSubstr("huge"));
}

TEST_P(Objects, ATargetOfFourGigabytesIsOutOfMemoryOnLlvmpipe) {
  if (device_->renderer().find("llvmpipe") == std::string::npos) GTEST_SKIP() << "a GPU may have it";
  EXPECT_THAT(errorOf([] { Texture::image2D("4 GB", GL_RGBA32F, 16384, 16384); }),
              AllOf(HasSubstr("out of memory"), HasSubstr("'4 GB'"), HasSubstr("--size")));
}

TEST_P(Objects, TextureBeyondTheLimitsIsAnError) {
  const int size = limits().textureSize;
  EXPECT_THAT(
      errorOf([&] { Texture::image2D("wide", GL_R8, size + 1, 1); }),
      AllOf(HasSubstr("'wide'"), HasSubstr(std::to_string(size + 1)), HasSubstr("1 to " + std::to_string(size))));
  EXPECT_THAT(errorOf([] { Texture::image2D("none", GL_R8, 0, 1); }), HasSubstr("'none'"));
  EXPECT_THAT(errorOf([] { Texture::image3D("deep", GL_R8, 1, 1, limits().texture3dSize + 1); }), HasSubstr("'deep'"));
}

TEST_P(Objects, TextureTakesExactlyItsTexels) {
  Texture texture = Texture::image2D("small", GL_RG32F, 3, 2);
  EXPECT_THAT(errorOf([&] { texture.upload(GL_RG, std::vector<float>(11)); }),
              AllOf(HasSubstr("44 bytes"), HasSubstr("takes 48")));
  std::vector<float> values(12);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
  texture.upload(GL_RG, values);
  std::vector<float> got(12);
  glGetTextureImage(texture.id(), 0, GL_RG, GL_FLOAT, 48, got.data());
  EXPECT_EQ(got, values);
}

TEST_P(Objects, BufferTextureHasTheTexelsOfItsBuffer) {
  const Buffer buffer = Buffer::of("floats", std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8});
  EXPECT_EQ(Texture::overBuffer("vec4", GL_RGBA32F, buffer).width(), 2);
  EXPECT_EQ(Texture::overBuffer("float", GL_R32F, buffer).width(), 8);
}

TEST_P(Objects, FramebufferOfManyTargetsClearsAndReadsEach) {
  const Texture floats = Texture::image2D("floats", GL_RGBA32F, 5, 3), ints = Texture::image2D("ints", GL_R32UI, 5, 3);
  const Framebuffer framebuffer("two", {floats, ints});
  framebuffer.clear(0, std::array<float, 4>{-3e38F, 0, 1, 2});
  framebuffer.clear(1, std::array<std::uint32_t, 4>{0xfffffffeU});
  EXPECT_THAT(framebuffer.readFloats(0, GL_RED), AllOf(Each(-3e38F), testing::SizeIs(15)));
  EXPECT_THAT(framebuffer.readUints(1, GL_RED_INTEGER), AllOf(Each(0xfffffffeU), testing::SizeIs(15)));
}

TEST_P(Objects, FramebufferThatCannotBeDrawnToSaysWhy) {
  const Texture shared = Texture::image2D("shared exponent", GL_RGB9_E5, 4, 4);
  EXPECT_THAT(errorOf([&] { Framebuffer("bad", {shared}); }), AllOf(HasSubstr("'bad'"), HasSubstr("format")));
  const Texture a = Texture::image2D("a", GL_R8, 4, 4), b = Texture::image2D("b", GL_R8, 4, 5);
  EXPECT_THAT(errorOf([&] { Framebuffer("uneven", {a, b}); }), AllOf(HasSubstr("'b' is 4 x 5"), HasSubstr("4 x 4")));
  const Framebuffer::Targets many(static_cast<std::size_t>(limits().drawBuffers) + 1, a);
  EXPECT_THAT(errorOf([&] { Framebuffer("many", many); }), AllOf(HasSubstr("'many'"), HasSubstr("--k")));
  EXPECT_THAT(errorOf([&] { Framebuffer("none", {}); }), HasSubstr("'none'"));
}

TEST_P(Objects, UniformsReachTheShader) {
  const Texture target = Texture::image2D("target", GL_RGBA32F, 1, 1);
  const Framebuffer framebuffer("target", {target});
  const Program program = makeProgram(kFullScreenVertex, R"(
uniform float f;
uniform int i;
uniform uint u;
uniform vec3 v;
uniform mat4 m;
uniform float a[3];
out vec4 colour;
void main() { colour = vec4(f + float(i) + float(u), v.z, m[3][0], a[2] * FACTOR); }
)",
                                      {{{"FACTOR", "2.0"}}, {}});
  program.set("f", 0.5F);
  program.set("i", -3);
  program.set("u", 10U);
  program.set("v", glm::vec3(0, 0, 4));
  glm::mat4 m(1.0F);
  m[3][0] = 9;
  program.set("m", m);
  program.set("a", std::vector<float>{1, 2, 3});
  program.set("nobody", 1.0F);
  EXPECT_TRUE(program.uses("f"));
  EXPECT_FALSE(program.uses("nobody"));
  framebuffer.bind();
  program.use();
  drawFullScreen(1);
  EXPECT_EQ(framebuffer.readFloats(0), (std::vector<float>{7.5F, 4, 9, 6}));
}

TEST_P(Objects, VertexArrayFeedsFloatsIntegersAndIndices) {
  // Point i of four lands on pixel x[i]; the third is not among the indices.
  const Buffer points = Buffer::of("x", std::vector<float>{0, 1, 2, 3});
  const Buffer numbers = Buffer::of("n", std::vector<std::uint32_t>{9, 10, 11, 0xffffffffU});
  const Buffer indices = Buffer::of("indices", std::vector<std::uint32_t>{3, 0, 1});
  VertexArray array("points");
  array.attribute(0, points, 1, GL_FLOAT, 4);
  array.integerAttribute(1, numbers, 1, GL_UNSIGNED_INT, 4);
  array.elements(indices);
  const Texture target = Texture::image2D("target", GL_R32UI, 4, 1);
  const Framebuffer framebuffer("target", {target});
  const Program program = makeProgram(R"(
layout(location = 0) in float x;
layout(location = 1) in uint n;
flat out uint number;
void main() {
  number = n;
  gl_Position = vec4((x + 0.5) / 2.0 - 1.0, 0.0, 0.0, 1.0);
}
)",
                                      "flat in uint number;\nout uint colour;\nvoid main() { colour = number; }");
  framebuffer.bind();
  framebuffer.clear(0, std::array<std::uint32_t, 4>{});
  program.use();
  array.bind();
  glDrawElements(GL_POINTS, 3, GL_UNSIGNED_INT, nullptr);
  EXPECT_EQ(framebuffer.readUints(0, GL_RED_INTEGER), (std::vector<std::uint32_t>{9, 10, 0, 0xffffffffU}));
}

TEST_P(Objects, CheckReportsAnErrorOnceAndSaysWhatWasDone) {
  glBindTextureUnit(0, 12345);
  EXPECT_THAT(errorOf([] { checkGl("binding nonsense"); }),
              AllOf(HasSubstr("binding nonsense"), HasSubstr("GL_INVALID")));
  EXPECT_NO_THROW(checkGl("going on"));
}

HAVS_FOR_EVERY_DEVICE(Objects);

}  // namespace
}  // namespace havs
