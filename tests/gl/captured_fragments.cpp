#include "gl/captured_fragments.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "core/arithmetic.h"
#include "render/gl/mesh_buffers.h"
#include "render/gl/tile.h"
#include "render/make_renderer.h"
#include "support/gl_test.h"

namespace havs::test {
namespace {

constexpr const char* kCapture = R"(
#include "core/language.glsl"
#include "payload.glsl"
#include "core/kbuffer.glsl"
#include "incoming_fragment.glsl"
layout(location = 0) inout uvec4 seen;  // x: how many fragments have come
layout(std430, binding = 3) writeonly buffer Captured { uvec2 captured[]; };
uniform int pixelsPerRow, capacity;

void main() {
  Fragment f = incomingFragment();
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (int(seen.x) < capacity)
    captured[(pixel.y * pixelsPerRow + pixel.x) * capacity + int(seen.x)] =
        uvec2(floatBitsToUint(f.payload), floatBitsToUint(f.distance));
  seen.x += 1u;
}
)";

using Bits = std::array<std::uint32_t, 2>;

CapturedFragment unpacked(const Bits& bits) {
  constexpr std::uint32_t kEntry = 0x80000000u, kExit = 0x40000000u;  // as in payload.glsl
  const int kind = bits[0] & kEntry ? 1 : bits[0] & kExit ? -1 : 0;
  return {std::bit_cast<float>(bits[0] & ~(kEntry | kExit)), std::bit_cast<float>(bits[1]), kind};
}

/// Draws with room for `capacity` fragments a pixel; how many there were of each.
std::vector<std::uint32_t> drawInto(const Buffer& list, int capacity, const MeshBuffers& mesh, const View& view,
                                    const Program& program, const Framebuffer& framebuffer) {
  const Tile whole{0, 0, view.width, view.height};
  framebuffer.bind();
  for (const GLenum capability : {GL_DEPTH_TEST, GL_CULL_FACE, GL_BLEND}) glDisable(capability);
  framebuffer.clear(0, std::array<std::uint32_t, 4>{});
  list.bindBase(GL_SHADER_STORAGE_BUFFER, 3);
  program.use();
  program.set("toClip", glm::mat4(clipMatrix(view, whole)));
  program.set("forward", glm::vec3(view.forward));
  program.set("firstBoundaryVertex", mesh.firstBoundaryVertex());
  program.set("pixelToRay", glm::vec4(pixelToRay(view, whole)));
  program.set("pixelsPerRow", view.width);
  program.set("capacity", capacity);
  mesh.drawInBatches([&](std::size_t first) { program.set("firstFace", static_cast<int>(first)); });
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  return framebuffer.readUints(0, GL_RED_INTEGER);
}

/// Whether the shader would count the fragment as late; it goes into the buffer otherwise.
template <int K>
std::uint32_t countLateOf(const std::vector<CapturedFragment>& fragments, float tolerance, float same) {
  using A = Arithmetic<FloatLane, K>;
  typename A::KBuffer buffer;
  for (auto& entry : buffer.entry) entry = A::emptyFragment();
  typename A::PixelState state{0, 0};
  std::uint32_t late = 0;
  for (const CapturedFragment& f : fragments) {
    const auto fragment = A::makeFragment(f.scalar, f.distance, static_cast<float>(f.kind));
    if (A::isLateBy(buffer, state, fragment, tolerance)) {
      ++late;
      continue;
    }
    typename A::Fragment front;
    A::insertFragment(buffer, fragment, same, front);
    A::leaveBefore(state, front, buffer);
  }
  return late;
}

using CountLate = std::uint32_t (*)(const std::vector<CapturedFragment>&, float, float);
template <int... Before>
constexpr std::array<CountLate, sizeof...(Before)> countTable(std::integer_sequence<int, Before...>) {
  return {countLateOf<Before + 1>...};
}
constexpr auto kCountLate = countTable(std::make_integer_sequence<int, 14>());

}  // namespace

CapturedPicture captureFragments(const PreparedScene& prepared, const View& view, const std::string& sort) {
  FaceOrder order;
  sortMethod(sort).make({prepared.points, prepared.mesh.tetrahedra, &prepared.faces})->sort(viewPointOf(view), order);
  MeshBuffers mesh(prepared);
  mesh.setOrder(order);
  ShaderOptions options = kFetch;
  options.defines["HAVS_K"] = "1";  // of the k-buffer's types, which go unused
  if (prepared.facts().cellData) options.defines["HAVS_CELL_DATA"] = "1";
  const Program program("capture", {{GL_VERTEX_SHADER, shaderSource("faces.vert")},
                                    {GL_FRAGMENT_SHADER, shaderSourceFromText("capture.frag", kCapture, options)}});
  const Texture target = Texture::image2D("seen", GL_RGBA32UI, view.width, view.height);
  const Framebuffer framebuffer("seen", {target});

  const auto counts = drawInto(Buffer("none", sizeof(Bits)), 0, mesh, view, program, framebuffer);
  const std::size_t capacity = *std::max_element(counts.begin(), counts.end());
  const Buffer list("captured", counts.size() * capacity * sizeof(Bits));
  drawInto(list, static_cast<int>(capacity), mesh, view, program, framebuffer);
  const auto captured = list.read<Bits>(counts.size() * capacity);

  CapturedPicture picture(counts.size());
  const auto width = static_cast<std::size_t>(view.width), height = static_cast<std::size_t>(view.height);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    auto& fragments = picture[(height - 1 - i / width) * width + i % width];  // OpenGL's rows go up
    for (std::size_t j = 0; j < counts[i]; ++j) fragments.push_back(unpacked(captured[i * capacity + j]));
  }
  return picture;
}

std::uint32_t countLate(const std::vector<CapturedFragment>& fragments, const std::string& sort, int k,
                        float tolerance) {
  return kCountLate.at(static_cast<std::size_t>(k - 1))(fragments, tolerance,
                                                        sortMethod(sort).isBelieved ? tolerance : 0);
}

std::vector<CapturedFragment> inHalves(std::vector<CapturedFragment> fragments) {
  for (CapturedFragment& f : fragments) {
    int exponent = 0;
    std::frexp(f.distance, &exponent);
    const float step = std::ldexp(1.0f, std::max(exponent, -13) - 11);  // of halves, subnormal ones too
    f.distance = std::nearbyint(f.distance / step) * step;
  }
  return fragments;
}

}  // namespace havs::test
