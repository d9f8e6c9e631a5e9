// Prints how many fragments come too late for a k-buffer of 1 to 14 entries, for each order:
//   count_misordered [--tf NAME] MESH SIZE ORDER...
// at the default camera; VIEWS=n in the environment: summed over n cameras around the mesh, all of them perspective but
// every third. With a transfer function only the cells that show anything are looked at, in the order of their own and
// in that of the whole mesh. The picture is not drawn.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "core/error.h"
#include "scene/visible_part.h"
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

FaceOrder orderOf(const PreparedScene& scene, const std::string& name, const View& view) {
  FaceOrder order;
  sortMethod(name).make({scene.points, scene.mesh.tetrahedra, &scene.faces})->sort(test::viewPoint(view), order);
  return order;
}

/// The order of the whole mesh, without the faces whose cells show nothing, in the numbers of the part.
FaceOrder filtered(const FaceOrder& order, const PreparedScene& whole) {
  const std::vector<unsigned char> shown = shownCells(whole);
  const auto isShown = [&](Index cell) { return cell != kNoIndex && shown[cell] != 0; };
  std::vector<Index> numbers(whole.faces.size(), kNoIndex);
  Index count = 0;
  for (std::size_t f = 0; f < numbers.size(); ++f)
    if (isShown(whole.faces.cells[f][0]) || isShown(whole.faces.cells[f][1])) numbers[f] = count++;
  FaceOrder result;
  for (const Index face : order.faces)
    if (numbers[face] != kNoIndex) result.faces.push_back(numbers[face]);
  return result;
}

/// `orderFrom(view)`: the order to replay. Sums over the views.
template <class OrderFrom>
void print(const std::string& name, const OrderFrom& orderFrom, const PreparedScene& scene,
           const std::vector<View>& views) {
  std::vector<int> ks(14);
  std::iota(ks.begin(), ks.end(), 1);
  std::vector<test::ReplayResult> sums(ks.size());
  std::size_t cycles = 0;
  for (const View& view : views) {
    const FaceOrder order = orderFrom(view);
    cycles += order.cycles;
    const auto results = test::replay({scene.points, &scene.faces, order.faces, {}, view}, ks);
    for (std::size_t i = 0; i < ks.size(); ++i) add(results[i], sums[i]);
  }
  fmt::print("{}: {} fragments, {} cycles cut, {} pixels unbalanced\n   k  misordered    pixels\n", name,
             sums[0].fragments, cycles, sums[0].unbalancedPixels);
  for (std::size_t i = 0; i < ks.size(); ++i)
    fmt::print("  {:2}  {:10}  {:8}\n", ks[i], sums[i].misordered, sums[i].misorderedPixels);
}

void countMisordered(const Scene& scene, bool visibleOnly, const std::vector<std::string>& orders) {
  StageTimes stages;
  const PreparedScene whole = prepareScene(scene, stages);
  const auto part = visibleOnly ? visiblePart(whole) : std::nullopt;
  const PreparedScene& drawn = part ? *part : whole;
  const char* const wanted = std::getenv("VIEWS");
  const std::vector<View> views =
      viewsAround(whole.frame, scene.width, wanted != nullptr ? std::max(1, std::atoi(wanted)) : 1);
  fmt::print("{}: {} points, {} of {} tetrahedra, {} faces ({} boundary), {} x {} pixels\n", scene.mesh.string(),
             drawn.points.size(), drawn.mesh.tetrahedra.size(), whole.mesh.tetrahedra.size(), drawn.faces.size(),
             drawn.faces.boundaryCount, scene.width, scene.height);
  if (drawn.mesh.tetrahedra.empty()) return;
  for (const std::string& name : orders) {
    print(
        name, [&](const View& view) { return orderOf(drawn, name, view); }, drawn, views);
    if (part)
      print(
          name + " of the whole mesh", [&](const View& view) { return filtered(orderOf(whole, name, view), whole); },
          drawn, views);
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  Scene scene;
  const bool visibleOnly = words.size() > 1 && words[0] == "--tf";
  if (visibleOnly) {
    scene.transferFunction = words[1];
    words.erase(words.begin(), words.begin() + 2);
  }
  const int size = words.size() > 1 ? std::atoi(words[1].c_str()) : 0;
  if (words.size() < 3 || size < 1 || size > 16384) {
    fmt::print(stderr,
               "count_misordered [--tf NAME] MESH SIZE ORDER...   SIZE in 1 .. 16384, ORDER as havs render --sort\n");
    return 2;
  }
  scene.mesh = words[0];
  scene.width = scene.height = size;
  try {
    countMisordered(scene, visibleOnly, {words.begin() + 2, words.end()});
  } catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return error.exitStatus();
  }
}
