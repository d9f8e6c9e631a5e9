// Prints the milliseconds of buildFaces and of every order (medians of 5 after one to warm up), wall and processor, on
// a ball of N^3 bricks, six tetrahedra each, numbered brick by brick; with "shuffled" its cells and points are numbered
// at random, the worst case for caches:
//   time_order N [shuffled]
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <random>

#include "core/memory.h"
#include "core/parallel.h"
#include "core/stage_times.h"
#include "mesh/local_frame.h"
#include "support/meshes.h"
#include "support/replay.h"

namespace {

void shuffle(havs::TetMesh& mesh) {
  std::mt19937 random(1);
  std::vector<havs::Index> place(mesh.points.size());
  std::iota(place.begin(), place.end(), havs::Index{0});
  std::shuffle(place.begin(), place.end(), random);
  std::vector<havs::Vec3> points(mesh.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) points[place[i]] = mesh.points[i];
  mesh.points = std::move(points);
  for (havs::Tetrahedron& cell : mesh.tetrahedra)
    for (havs::Index& v : cell) v = place[v];
  std::shuffle(mesh.tetrahedra.begin(), mesh.tetrahedra.end(), random);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace havs;
  const int n = argc > 1 ? std::atoi(argv[1]) : 55;
  TetMesh mesh = test::ball(n);
  if (argc > 2) shuffle(mesh);
  StageTimes wall, processor;
  Faces faces;
  const auto memoryBefore = peakMemoryBytes();
  auto measure = [&](const std::string& name, const auto& work) {
    for (int run = 0; run < 5; ++run) {
      const double before = cpuSeconds();
      {
        const ScopedStage stage(wall, name);
        work();
      }
      processor.add(name, 1e3 * (cpuSeconds() - before));
    }
  };
  measure("faces", [&] { faces = buildFaces(mesh); });
  fmt::print("{} tetrahedra, {} faces, {} threads\n", mesh.tetrahedra.size(), faces.size(), threadCount());
  const LocalFrame frame = localFrame(mesh);
  const std::vector<Vec3> points = localPoints(mesh, frame);
  for (const SortMethod& method : sortMethods()) {
    const auto sorter = method.make({points, mesh.tetrahedra, &faces});
    FaceOrder order;
    ViewPoint view;
    view.eye = {2.1, 1.3, 3.2};
    sorter->sort(view, order);
    measure(method.name, [&] { sorter->sort(view, order); });
  }
  for (const auto& [stage, milliseconds] : wall.medians())
    fmt::print("{:12} {:8.1f} ms wall {:8.1f} ms processor\n", stage, milliseconds, processor.median(stage));
  fmt::print("memory       {:8.1f} bytes a tetrahedron at the peak, beyond the mesh\n",
             static_cast<double>(peakMemoryBytes() - memoryBefore) / static_cast<double>(mesh.tetrahedra.size()));
}
