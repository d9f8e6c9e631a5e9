// Prints how many fragments come too late for a k-buffer of 1 to 14 entries, for each order:
//   count_misordered MESH SIZE ORDER...
// at the default camera; VIEWS=n in the environment: summed over n cameras around the mesh, all of them perspective but
// every third. The picture is not drawn.
#include <fmt/format.h>

#include <algorithm>
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

/// The first is the default camera.
std::vector<View> viewsAround(const LocalFrame& frame, int size, int count) {
  std::vector<View> views;
  for (int i = 0; i < count; ++i) {
    Camera camera;
    camera.azimuth += 137.508 * i;  // the golden angle: never the same direction twice
    camera.elevation = i == 0 ? camera.elevation : -80 + 160.0 * i / count;
    if (i % 3 == 2) camera.projection = Projection::orthographic;
    views.push_back(makeView(camera, frame, size, size));
  }
  return views;
}

void add(const test::ReplayResult& one, test::ReplayResult& sum) {
  sum.fragments += one.fragments;
  sum.misordered += one.misordered;
  sum.misorderedPixels += one.misorderedPixels;
  sum.unbalancedPixels += one.unbalancedPixels;
}

void countMisordered(const std::string& file, int size, std::span<char* const> orders) {
  const TetMesh mesh = repairMesh(readMesh(file));
  const Faces faces = buildFaces(mesh);
  const LocalFrame frame = localFrame(mesh);
  const std::vector<Vec3> points = localPoints(mesh, frame);
  std::vector<int> ks(14);
  std::iota(ks.begin(), ks.end(), 1);
  const char* const wanted = std::getenv("VIEWS");
  const std::vector<View> views = viewsAround(frame, size, wanted != nullptr ? std::max(1, std::atoi(wanted)) : 1);
  fmt::print("{}: {} points, {} tetrahedra, {} faces ({} boundary), {} x {} pixels, {} views\n", file,
             mesh.points.size(), mesh.tetrahedra.size(), faces.size(), faces.boundaryCount, size, size, views.size());
  for (const std::string name : orders) {
    const auto sorter = sortMethod(name).make({points, mesh.tetrahedra, &faces});
    FaceOrder order;
    std::vector<test::ReplayResult> sums(ks.size());
    std::size_t cycles = 0;
    for (const View& view : views) {
      sorter->sort(test::viewPoint(view), order);
      cycles += order.cycles;
      const auto results = test::replay({points, &faces, order.faces, {}, view}, ks);
      for (std::size_t i = 0; i < ks.size(); ++i) add(results[i], sums[i]);
    }
    fmt::print("{}: {} fragments, {} cycles cut, {} pixels unbalanced\n   k  misordered    pixels\n", name,
               sums[0].fragments, cycles, sums[0].unbalancedPixels);
    for (std::size_t i = 0; i < ks.size(); ++i)
      fmt::print("  {:2}  {:10}  {:8}\n", ks[i], sums[i].misordered, sums[i].misorderedPixels);
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
