// Prints the milliseconds of buildFaces and of every order on a box of N^3 cubes, six tetrahedra each (medians of 5 after one to warm up):
//   time_order N
#include <fmt/format.h>

#include <cstdlib>

#include "core/memory.h"
#include "core/parallel.h"
#include "core/stage_times.h"
#include "mesh/local_frame.h"
#include "support/meshes.h"
#include "support/replay.h"

int main(int argc, char** argv) {
  using namespace havs;
  const int n = argc > 1 ? std::atoi(argv[1]) : 55;
  const TetMesh mesh = test::ball(n);
  StageTimes times;
  Faces faces;
  const auto memoryBefore = peakMemoryBytes();
  for (int run = 0; run < 5; ++run) {
    ScopedStage stage(times, "faces");
    faces = buildFaces(mesh);
  }
  fmt::print("{} tetrahedra, {} faces, {} threads\n", mesh.tetrahedra.size(), faces.size(), threadCount());
  const LocalFrame frame = localFrame(mesh);
  const std::vector<Vec3> points = localPoints(mesh, frame);
  for (const SortMethod& method : sortMethods()) {
    const auto sorter = method.make({points, mesh.tetrahedra, &faces});
    FaceOrder order;
    ViewPoint view;
    view.eye = {2.1, 1.3, 3.2};
    sorter->sort(view, order);
    for (int run = 0; run < 5; ++run) {
      ScopedStage stage(times, method.name);
      sorter->sort(view, order);
    }
  }
  for (const auto& [stage, milliseconds] : times.medians()) fmt::print("{:12} {:8.1f} ms\n", stage, milliseconds);
  fmt::print("memory       {:8.1f} bytes a tetrahedron at the peak, beyond the mesh\n",
             static_cast<double>(peakMemoryBytes() - memoryBefore) / static_cast<double>(mesh.tetrahedra.size()));
}
