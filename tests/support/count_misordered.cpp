// Prints how many fragments come too late for a k-buffer of 1 to 14 entries, for each order:
//   count_misordered [--tf NAME] MESH SIZE ORDER...
// at the default camera. With a transfer function only the cells that show anything are looked at, in the order of
// their own and in that of the whole mesh. The picture is not drawn.
#include <fmt/format.h>

#include <cstdlib>
#include <numeric>

#include "core/error.h"
#include "scene/visible_part.h"
#include "support/replay.h"

namespace {

using namespace havs;

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

void print(const std::string& name, const FaceOrder& order, const PreparedScene& scene, const View& view) {
  std::vector<int> ks(14);
  std::iota(ks.begin(), ks.end(), 1);
  const auto results = test::replay({scene.points, &scene.faces, order.faces, {}, view}, ks);
  fmt::print("{}: {} fragments, {} cycles cut, {} pixels unbalanced\n   k  misordered    pixels\n", name,
             results[0].fragments, order.cycles, results[0].unbalancedPixels);
  for (std::size_t i = 0; i < ks.size(); ++i)
    fmt::print("  {:2}  {:10}  {:8}\n", ks[i], results[i].misordered, results[i].misorderedPixels);
}

void countMisordered(const Scene& scene, bool visibleOnly, const std::vector<std::string>& orders) {
  StageTimes stages;
  const PreparedScene whole = prepareScene(scene, stages);
  const auto part = visibleOnly ? visiblePart(whole) : std::nullopt;
  const PreparedScene& drawn = part ? *part : whole;
  const View view = viewOf(scene, whole);
  fmt::print("{}: {} points, {} of {} tetrahedra, {} faces ({} boundary), {} x {} pixels\n", scene.mesh.string(),
             drawn.points.size(), drawn.mesh.tetrahedra.size(), whole.mesh.tetrahedra.size(), drawn.faces.size(),
             drawn.faces.boundaryCount, scene.width, scene.height);
  if (drawn.mesh.tetrahedra.empty()) return;
  for (const std::string& name : orders) {
    print(name, orderOf(drawn, name, view), drawn, view);
    if (part) print(name + " of the whole mesh", filtered(orderOf(whole, name, view), whole), drawn, view);
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
