// Prints how many fragments come too late for a k-buffer of 1 to 14 entries, for each order:
//   count_misordered MESH SIZE ORDER...
// at the default camera. The picture is not drawn.
#include <fmt/format.h>

#include <cstdlib>
#include <numeric>

#include "core/error.h"
#include "mesh/defects.h"
#include "mesh/local_frame.h"
#include "mesh/read.h"
#include "scene/camera.h"
#include "support/replay.h"

namespace {

using namespace havs;

void countMisordered(const std::string& file, int size, std::span<char* const> orders) {
  const TetMesh mesh = repairMesh(readMesh(file));
  const Faces faces = buildFaces(mesh);
  const LocalFrame frame = localFrame(mesh);
  const std::vector<Vec3> points = localPoints(mesh, frame);
  const View view = makeView(Camera{}, frame, size, size);
  std::vector<int> ks(14);
  std::iota(ks.begin(), ks.end(), 1);
  fmt::print("{}: {} points, {} tetrahedra, {} faces ({} boundary), {} x {} pixels\n", file, mesh.points.size(),
             mesh.tetrahedra.size(), faces.size(), faces.boundaryCount, size, size);
  for (const std::string name : orders) {
    FaceOrder order;
    sortMethod(name).make({points, mesh.tetrahedra, &faces})->sort(test::viewPoint(view), order);
    const auto results = test::replay({points, &faces, order.faces, {}, view}, ks);
    fmt::print("{}: {} fragments, {} cycles cut, {} pixels unbalanced\n   k  misordered    pixels\n", name,
               results[0].fragments, order.cycles, results[0].unbalancedPixels);
    for (std::size_t i = 0; i < ks.size(); ++i)
      fmt::print("  {:2}  {:10}  {:8}\n", ks[i], results[i].misordered, results[i].misorderedPixels);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int size = argc > 2 ? std::atoi(argv[2]) : 0;
  if (argc < 4 || size < 1 || size > 16384) {
    fmt::print(stderr, "count_misordered MESH SIZE ORDER...   SIZE in 1 .. 16384, ORDER as havs render --sort\n");
    return 2;
  }
  try {
    countMisordered(argv[1], size, std::span(argv + 3, static_cast<std::size_t>(argc - 3)));
  } catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return error.exitStatus();
  }
}
