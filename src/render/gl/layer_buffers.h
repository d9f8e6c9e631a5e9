#pragma once
#include "gl/buffer.h"
#include "gl/program.h"
#include "render/gl/tile.h"
#include "scene/ray_layers.h"

namespace havs {

/// The layers of a picture's rays, as shaders/layers.glsl reads them.
class LayerBuffers {
 public:
  /// Throws Error{running} where a shader cannot see as much memory.
  explicit LayerBuffers(const RayLayers& layers);
  /// For drawing into a tile.
  void bind(const Program& program, const Tile& tile) const;

 private:
  int width_, height_;
  Buffer begins_, distances_, colors_;
};

}  // namespace havs
