// Rays through meshes that TetGen made: not convex, with holes, tunnels and hollows.
#include <gtest/gtest.h>

#include "mesh/defects.h"
#include "mesh/local_frame.h"
#include "mesh/read.h"
#include "unit/light/light_scene.h"

namespace havs::test {
namespace {

TEST(MeshTracer, MeshesOfTetGenAgainstEachCellClipped) {
  for (const char* file : {HAVS_MESHES "/bracket.poly", HAVS_MESHES "/nested_shells.poly"}) {
    ReadOptions reading;
    reading.tetgenSwitches = "pq";
    TetMesh mesh = repairMesh(readMesh(file, reading));
    mesh.points = localPoints(mesh, localFrame(mesh));
    std::vector<double> scalars = smoothField(mesh.points);
    const LightScene scene(std::move(mesh), std::move(scalars), curveOf({{0, 1}, {1, 8}}));  // linear: trapezia
    const MeshTracer tracer(scene.medium());
    PointRays rays(tracer);
    for (std::size_t p = 0; p < scene.mesh.points.size(); p += 9) {
      rays.startAt(static_cast<Index>(p));
      for (const Vec3& d : generalDirections(12)) {
        double expected = 0;
        for (const CellStretch& cell : clipCells(scene, scene.mesh.points[p], d))
          expected += cell.range.length() * (1 + 3.5 * (cell.sFirst + cell.sLast));
        // Rays from the boundary are turned by 1e-12, over a length of 2 at slopes of 1 in 10 and kappa of 8.
        EXPECT_NEAR(rays.opticalDepth(d), expected, 2 * 10 * 8 * LineFrame::kTurn) << file << ' ' << p;
      }
    }
  }
}

}  // namespace
}  // namespace havs::test
