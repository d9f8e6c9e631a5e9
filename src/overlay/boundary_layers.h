#pragma once
#include <vector>

#include "overlay/boundary_edges.h"
#include "scene/overlays.h"
#include "scene/ray_layers.h"
#include "scene/view.h"

namespace havs {

/// What rays meet of the boundary surface and its wire frame, in double. A ray meets a face by the fill rule of
/// raster/edge_function.h, before the eye, at the distance that the reference's segments have. There the frame lies
/// over the surface: the colours of both with their opacities, the frame's times its coverage: lineCoverage of the
/// distance in the picture from the pixel's centre to the nearest of the face's edges (Baerentzen, Nielsen, Gjol,
/// Larsen, Christensen, Single-pass wireframe rendering, 2006). So at a silhouette a line has the half that lies on a
/// face. With a feature angle the edges are those at the face's corners that bound a face turned to the eye as it is
/// itself, so that a line does not break where it only passes a face by a corner.
class BoundaryLayers {
 public:
  /// `prepared` must outlive it. Finds the boundary's faces, and which of their edges are drawn.
  BoundaryLayers(const PreparedScene& prepared, const Overlays& overlays);
  /// Parallel; the same for any number of threads. Layers without opacity are left out.
  RayLayers of(const View& view) const;

 private:
  struct InView;
  const PreparedScene& prepared_;
  Overlays overlays_;
  std::vector<BoundaryFace> faces_;
  std::optional<FeatureEdges> features_;  ///< where not all edges are drawn
};

}  // namespace havs
