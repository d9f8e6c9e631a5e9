#pragma once
#include <vector>

#include "render/plan.h"
#include "scene/view.h"

namespace havs {

/// A rectangle of the picture that is drawn at once, rows from the bottom up as OpenGL counts.
struct Tile {
  int x, y, width, height;
};

/// The picture cut into the plan's tiles.
std::vector<Tile> tilesOf(const View& view, const RenderPlan& plan);

/// From the local frame to the clip coordinates of a tile; made in double. Depth only serves to clip at the near plane.
Mat4 clipMatrix(const View& view, const Tile& tile);

/// Scale (x, y) and offset (z, w) from the tile's window coordinates to the slope of the pixel's ray against the view
/// direction; 0 for parallel rays.
Vec4 pixelToRay(const View& view, const Tile& tile);

/// The same to where the pixel's ray passes through the plane of depth 0 (the mesh's centre), along right and up.
Vec4 pixelToBase(const View& view, const Tile& tile);

}  // namespace havs
