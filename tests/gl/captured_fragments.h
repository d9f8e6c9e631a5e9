#pragma once
// The fragments that the rasteriser makes of a mesh, read back in the order in which they come to each pixel, and the
// order certificate replayed from them.
#include <cstdint>
#include <string>
#include <vector>

#include "scene/prepared_scene.h"
#include "scene/view.h"

namespace havs::test {

struct CapturedFragment {
  float scalar, distance;
  int kind;
};
/// Of each pixel, row 0 on top.
using CapturedPicture = std::vector<std::vector<CapturedFragment>>;

/// Draws the faces in the named order through faces.vert and incoming_fragment.glsl, as the k-buffer does, on the
/// current device, which must have framebuffer fetch: a pixel's fragments then come in their order. Each writes itself
/// to its pixel's list in a storage buffer.
CapturedPicture captureFragments(const PreparedScene& prepared, const View& view, const std::string& sort);

/// The late fragments of one pixel for k from 1 to 14, by the shader's own arithmetic in float; captured in the
/// named order.
std::uint32_t countLate(const std::vector<CapturedFragment>& fragments, const std::string& sort, int k,
                        float tolerance = 1e-6f);

/// With distances rounded to the nearest half float.
std::vector<CapturedFragment> inHalves(std::vector<CapturedFragment> fragments);

}  // namespace havs::test
