#include "app/clip_options.h"

#include <fmt/format.h>

#include <charconv>

#include "core/error.h"
#include "scene/clip_scene.h"

namespace havs {
namespace {

/// Numbers with commas between them.
template <std::size_t count>
std::array<double, count> numbersOf(const std::string& text, const char* option, const char* tryThis) {
  std::array<double, count> numbers{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto [next, error] = std::from_chars(at, end, numbers[i]);
    const bool last = i + 1 == count;
    if (error != std::errc{} || (last ? next != end : next == end || *next != ','))
      failInput(fmt::format("'{}' is not {} numbers", text, count), option, tryThis);
    at = last ? next : next + 1;
  }
  return numbers;
}

ClipPlane planeOf(const std::string& text) {
  const auto n = numbersOf<6>(text, "--clip-plane", "write X,Y,Z,NX,NY,NZ: a point of it, and where what is kept lies");
  return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
}

ClipBox boxOf(const std::string& text, const char* option, bool keepsInside) {
  const auto n = numbersOf<6>(text, option, "write X0,X1,Y0,Y1,Z0,Z1: its lower and upper end along x, y and z");
  return {{n[0], n[2], n[4]}, {n[1], n[3], n[5]}, keepsInside};
}

void addEach(CLI::App& command, const char* name, std::vector<std::string>& values, const char* value,
             const char* description) {
  command.add_option(name, values, description)
      ->type_name(value)
      ->take_all()
      ->expected(1)
      ->group("What of the mesh is drawn");
}

}  // namespace

void addClipOptions(CLI::App& command, SceneOptions& options) {
  addEach(command, "--clip-plane", options.clipPlanes, "X,Y,Z,NX,NY,NZ",
          "Cut at the plane through X,Y,Z and keep the half that the normal NX,NY,NZ points to; may be given several "
          "times, as the next two: what is kept is in all of them");
  addEach(command, "--clip-box", options.clipBoxes, "X0,X1,Y0,Y1,Z0,Z1", "Keep what lies in the box");
  addEach(command, "--cut-box", options.cutBoxes, "X0,X1,Y0,Y1,Z0,Z1", "Cut the box away");
  command
      .add_option("--threshold", options.threshold,
                  "Draw only cells whose data lie in the range, at all of their points")
      ->type_name("LOW,HIGH")
      ->group("What of the mesh is drawn");
}

void setClipping(Scene& scene, const SceneOptions& options) {
  for (const std::string& text : options.clipPlanes) scene.clipPlanes.push_back(planeOf(text));
  for (const std::string& text : options.clipBoxes) scene.clipBoxes.push_back(boxOf(text, "--clip-box", true));
  for (const std::string& text : options.cutBoxes) scene.clipBoxes.push_back(boxOf(text, "--cut-box", false));
  if (options.threshold && *options.threshold != "none")
    scene.threshold = numbersOf<2>(*options.threshold, "--threshold", "write LOW,HIGH, such as 0,1.5");
  checkClipping(scene);
}

}  // namespace havs
