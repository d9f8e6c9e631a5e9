// Scene files: their keys, and the options that these stand for. A scene that is read can be written, and is then read
// as the same.
#include "app/clip_options.h"
#include "app/isosurface_options.h"
#include "app/light_options.h"
#include "app/overlay_options.h"
#include "app/scene_file.h"
#include "app/scene_views.h"
#include "fuzz/fuzz.h"

namespace {

using namespace havs;
using Paths = std::vector<std::filesystem::path>;

SceneOptions read(const std::filesystem::path& file, Paths& outputs) {
  SceneOptions options;
  options.mesh = file.string();
  readSceneFile(options, outputs, {});
  return options;
}

void requireSameWhenWritten(const SceneOptions& options, const Paths& outputs, const std::filesystem::path& beside) {
  const std::string written = sceneFileOf(options, outputs, beside);
  Paths again;
  const SceneOptions back = read(fuzz::asFile("again.json", written), again);
  fuzz::require(sceneFileOf(back, again, beside) == written, "a scene that was written is read as the same");
}

/// Each may refuse what it is for, the others go on.
void setAll(const SceneOptions& options) {
  Scene scene;
  fuzz::readOrRefuse([&] { setIsosurfaces(scene, options); });
  fuzz::readOrRefuse([&] { setOverlays(scene, options); });
  fuzz::readOrRefuse([&] { setClipping(scene, options); });
  fuzz::readOrRefuse([&] { setLight(scene, options); });
  fuzz::readOrRefuse([&] { options.background ? parseBackground(*options.background) : std::nullopt; });
  for (const SceneOptions& view : optionsOfViews(options))
    if (view.camera) fuzz::readOrRefuse([&] { parseCamera(*view.camera, Projection::perspective); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = fuzz::asFile("scene.json", fuzz::textOf(data, size));
  fuzz::readOrRefuse([&] {
    Paths outputs;
    const SceneOptions options = read(file, outputs);
    setAll(options);
    requireSameWhenWritten(options, outputs, file);
  });
  return 0;
}
