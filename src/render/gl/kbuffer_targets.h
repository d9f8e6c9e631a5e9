#pragma once
#include <optional>
#include <vector>

#include "gl/framebuffer.h"
#include "image/image.h"
#include "render/gl/tile.h"

namespace havs {

/// The render targets of the k-buffer as the plan has them: the colour and the entries (shaders/kbuffer_targets.glsl).
class KBufferTargets {
 public:
  /// For tiles of up to `width` x `height` pixels. Throws Error{running} when there is no memory.
  KBufferTargets(const RenderPlan& plan, int width, int height);

  int width() const { return framebuffer_.width(); }
  int height() const { return framebuffer_.height(); }
  /// Draws to them from now on, to the lower left part that the tile takes; they are empty.
  void begin(const Tile& tile) const;
  /// Puts the colours of the tile into the picture, whose rows go from the top down.
  void readInto(Image& image, const Tile& tile) const;

 private:
  void clear() const;
  void readHalves(float* pixels, const Tile& tile, int rowPixels) const;

  TargetFormat format_;
  int entryTargets_;
  std::vector<Texture> textures_;
  std::optional<Texture> stencil_;
  Framebuffer framebuffer_;
};

}  // namespace havs
