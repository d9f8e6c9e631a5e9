#pragma once
#include <vector>

#include "overlay/boundary_edges.h"
#include "scene/overlays.h"
#include "scene/ray_layers.h"
#include "scene/view.h"

namespace havs {

/// What rays meet of the boundary surface and its wire frame, in double. A ray meets a face by the fill rule of
/// raster/edge_function.h, before the eye, at the distance that the reference's segments have. There the frame lies
/// over the surface: the colours of both with their opacities, the frame's times its coverage, lineCoverage of the
/// distance in the picture from the pixel's centre to the nearest of the face's edges that are drawn, and of its
/// corners where any is drawn. (Distances to the edges of the own triangle, as in Baerentzen, Nielsen, Gjol, Larsen,
/// Christensen, Single-pass wireframe rendering, 2006; so a line is as wide as its two faces let it be, and at a
/// silhouette half.)
class BoundaryLayers {
 public:
  /// `prepared` must outlive it. Finds the boundary's faces, and which of their edges are drawn.
  BoundaryLayers(const PreparedScene& prepared, const Overlays& overlays);
  /// Parallel; the same for any number of threads. Layers without opacity are left out.
  RayLayers of(const View& view) const;

 private:
  const PreparedScene& prepared_;
  Overlays overlays_;
  std::vector<BoundaryFace> faces_;
};

}  // namespace havs
