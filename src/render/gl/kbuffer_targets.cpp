#include "render/gl/kbuffer_targets.h"

#include <algorithm>
#include <glm/gtc/packing.hpp>

namespace havs {
namespace {

constexpr float kEmptyDistance = -3.0e38f;    // as in core/kbuffer.glsl
constexpr std::uint32_t kEmptyWord = 0xFBFF;  // as in target_16f.glsl

std::vector<Texture> makeTextures(const RenderPlan& plan, int width, int height) {
  const GLenum format = plan.targetFormat.halfFloats ? GL_RGBA16UI : GL_RGBA32F;
  std::vector<Texture> textures;
  for (int i = 0; i <= plan.entryTargets; ++i)
    textures.push_back(Texture::image2D(i == 0 ? "colour" : "k-buffer " + std::to_string(i), format, width, height));
  return textures;
}

std::optional<Texture> stencilFor(const RenderPlan& plan, int width, int height) {
  if (!plan.marksDonePixels) return std::nullopt;
  return Texture::image2D("done pixels", GL_STENCIL_INDEX8, width, height);
}

}  // namespace

KBufferTargets::KBufferTargets(const RenderPlan& plan, int width, int height)
    : format_(plan.targetFormat),
      entryTargets_(plan.entryTargets),
      textures_(makeTextures(plan, width, height)),
      stencil_(stencilFor(plan, width, height)),
      framebuffer_("k-buffer", Framebuffer::Targets(textures_.begin(), textures_.end()),
                   stencil_ ? &*stencil_ : nullptr) {}

void KBufferTargets::begin(const Tile& tile) const {
  framebuffer_.bind();
  glViewport(0, 0, tile.width, tile.height);
  for (const GLenum capability : {GL_DEPTH_TEST, GL_CULL_FACE, GL_BLEND}) glDisable(capability);
  clear();
}

/// A pixel without colour, and every entry empty.
void KBufferTargets::clear() const {
  if (format_.halfFloats) {
    framebuffer_.clear(0, std::array<std::uint32_t, 4>{});
  } else {
    framebuffer_.clear(0, std::array<float, 4>{});
  }
  for (int i = 1; i <= entryTargets_; ++i)
    if (format_.halfFloats) {
      framebuffer_.clear(i, std::array{0u, kEmptyWord, 0u, kEmptyWord});
    } else {
      framebuffer_.clear(i, std::array{0.0f, kEmptyDistance, 0.0f, kEmptyDistance});
    }
}

void KBufferTargets::readInto(Image& image, const Tile& tile) const {
  const int top = image.height - tile.y - tile.height;
  if (format_.halfFloats) {
    readHalves(image.pixel(tile.x, top), tile, image.width);
  } else {
    framebuffer_.readInto(image.pixel(tile.x, top), 0, tile.width, tile.height, image.width);
  }
  for (int low = top, high = top + tile.height - 1; low < high; ++low, --high) {
    float* const row = image.pixel(tile.x, low);
    std::swap_ranges(row, row + std::size_t{4} * static_cast<std::size_t>(tile.width), image.pixel(tile.x, high));
  }
}

void KBufferTargets::readHalves(float* pixels, const Tile& tile, int rowPixels) const {
  const std::vector<std::uint32_t> words = framebuffer_.readUints(0);
  const auto values = [](int count) { return std::size_t{4} * static_cast<std::size_t>(count); };
  for (int y = 0; y < tile.height; ++y) {
    const auto row = words.begin() + static_cast<std::ptrdiff_t>(values(y) * static_cast<std::size_t>(width()));
    std::transform(row, row + static_cast<std::ptrdiff_t>(values(tile.width)),
                   pixels + values(y) * static_cast<std::size_t>(rowPixels),
                   [](std::uint32_t word) { return glm::unpackHalf1x16(static_cast<glm::uint16>(word)); });
  }
}

}  // namespace havs
