#pragma once
#include <span>
#include <vector>

#include "mesh/faces.h"
#include "scene/view.h"

namespace havs {

/// Marks the pixels whose centre lies within `distance` pixels of the projection of an edge of a boundary face: there a
/// rasteriser with a sub-pixel grid may fall on either side of the silhouette, which is no error of the method. One
/// byte a pixel, 1 = marked, row 0 on top. Default: 1/128 pixel, half a step of llvmpipe's grid of 1/256 in each of two
/// directions.
std::vector<unsigned char> boundaryEdgeMask(std::span<const Vec3> localPoints, const Faces& faces, const View& view,
                                            double distance = 1.0 / 128.0);

}  // namespace havs
