#pragma once
#include "core/parallel.h"
#include "light/mesh_tracer.h"

namespace havs {

/// Calls body(rays, p) for each point of the mask, from several threads; rays start at p.
template <class Body>
void forEachPoint(const MeshTracer& tracer, PointMask mask, const Body& body) {
  constexpr std::size_t kPoints = 64;
  parallelBlocks(0, tracer.medium().points.size(), kPoints, [&](std::size_t first, std::size_t last) {
    PointRays rays(tracer);
    for (std::size_t p = first; p < last; ++p) {
      if (!isIn(mask, p)) continue;
      rays.startAt(static_cast<Index>(p));
      body(rays, p);
    }
  });
}

}  // namespace havs
