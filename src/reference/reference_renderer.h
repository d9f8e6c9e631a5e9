#pragma once
#include <functional>
#include <memory>
#include <span>

#include "light/light_plan.h"
#include "reference/cell_segments.h"
#include "reference/ray_sums.h"
#include "scene/prepared_scene.h"
#include "scene/renderer.h"

namespace havs {

/// The ground truth: for each pixel the entry and exit of every cell that its ray crosses, sorted, each integrated
/// exactly (integrateSegment), in double throughout, on the CPU, by all threads. No table, no k-buffer, no order of the
/// faces. Every point of a ray inside the mesh belongs to exactly one cell, also where the ray runs through an edge or
/// a vertex. `function`: what a ray gathers. `prepared` must outlive it. Stages timed: draw.
std::unique_ptr<Renderer> makeReferenceRenderer(const PreparedScene& prepared, RayFunction function = rayColor);

/// The same of a lit scene (LitRays in reference/lit_ray.h); without `volume` its isosurfaces alone. Stages timed
/// besides: those of LightData.
std::unique_ptr<Renderer> makeLitReferenceRenderer(const PreparedScene& prepared, const LightPlan& light,
                                                   bool volume = true);

/// How the work is cut up; the picture does not depend on it.
struct ReferenceTiles {
  int side = 32;                      ///< pixels of a tile at most, each way
  double mostSegments = 1024 * 1024;  ///< tiles that may hold more (40 bytes each) are halved
};

/// What a ray meets, as SegmentCollector::at. Called once a pixel, also for empty rays, from several threads.
using RayVisitor = std::function<void(int x, int y, std::span<const CellSegment> segments)>;

/// Every ray of a view. Returns the number of tiles.
std::size_t visitRays(const PreparedScene& prepared, const View& view, const RayVisitor& visit,
                      const ReferenceTiles& tiles = {}, const Progress& progress = {});

/// The reference before it is rounded to float: premultiplied RGBA, row 0 on top.
std::vector<RayColor> referencePixels(const PreparedScene& prepared, const View& view,
                                      const ReferenceTiles& tiles = {});

}  // namespace havs
