#pragma once
#include <memory>

#include "scene/prepared_scene.h"
#include "scene/renderer.h"

namespace havs {

/// The ground truth: for each pixel the entry and exit of every cell that its ray crosses, sorted, each integrated
/// exactly (integrateSegment), in double throughout, on the CPU, by all threads. No table, no k-buffer, no order of the
/// faces. Every point of a ray inside the mesh belongs to exactly one cell, also where the ray runs through an edge or a
/// vertex. `prepared` must outlive it. Stages timed: draw.
std::unique_ptr<Renderer> makeReferenceRenderer(const PreparedScene& prepared);

}  // namespace havs
