// The camera as --camera takes it: angles, JSON, or a file with JSON.
#include "scene/camera.h"

#include <cmath>

#include "fuzz/fuzz.h"

namespace {

void requireView(const havs::Camera& camera, int width, int height) {
  using namespace havs;
  const View view = makeView(camera, {.center = Vec3(1, 2, 3), .radius = 4}, width, height);
  for (const Vec3& v : {view.eye, view.center, view.forward, view.right, view.up})
    fuzz::require(isFinite(v), "a view is finite");
  fuzz::require(view.halfWidth > 0 && view.halfHeight > 0, "a view has a size");
  fuzz::require(std::isfinite(view.halfWidth) && std::isfinite(view.halfHeight), "a view's size is finite");
  const double across = dot(view.right, view.up), ahead = dot(view.right, view.forward);
  fuzz::require(std::abs(across) < 1e-9 && std::abs(ahead) < 1e-9, "a view's directions are orthogonal");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace havs;
  const std::string text(fuzz::textOf(data, size));
  const auto file = fuzz::asFile("camera.json", text);
  for (const std::string& given : {text, file.string()})
    for (const Projection projection : {Projection::perspective, Projection::orthographic})
      fuzz::readOrRefuse([&] { requireView(parseCamera(given, projection), 640, 480); });
  return 0;
}
