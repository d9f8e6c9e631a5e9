#include "render/effects.h"

#include <algorithm>

#include "core/error.h"
#include "render/overlay_effects.h"
#include "scene/isosurface.h"

namespace havs {
namespace {

void checkIsosurfaceScene(const Scene& scene) {
  checkIsosurfaces(scene);
  const Mode& shown = mode(scene.mode);
  if (shown.gathering != Gathering::composite)
    failInput("the mode " + shown.name + " composites nothing, so it shows no isosurface", "--isosurface",
              "leave it out, or draw with --mode volume or isosurfaces");
  if (const Lookup chosen = lookupOf(scene); chosen.carries == Payload::color)
    failInput("fragments of the lookup '" + chosen.name + "' carry colours, from which no isosurface can be found",
              "--isosurface", "leave it out, or choose another --lookup");
}

void planIsosurfaces(RenderPlan& plan, const Scene& scene, const SceneFacts&, const Capabilities& capabilities) {
  const std::size_t count = scene.isosurfaces.size();
  plan.isosurfaces = true;
  plan.opaqueIsosurfaces =
      std::any_of(scene.isosurfaces.begin(), scene.isosurfaces.end(), [](const auto& s) { return s.opacity >= 1; });
  plan.defines.push_back({"HAVS_ISOSURFACES", "1"});
  addResource(plan, "isosurfaces",
              "the scene has " + std::to_string(count) + (count == 1 ? " isosurface" : " isosurfaces") +
                  ": segments are cut where they cross one",
              scene, capabilities);
}

}  // namespace

std::span<const Effect> effects() {
  static const std::vector<Effect> rows{
      {.name = "isosurfaces",
       .description = "surfaces of one value of the field, opaque or translucent",
       .wanted = [](const Scene& scene) { return !scene.isosurfaces.empty(); },
       .check = checkIsosurfaceScene,
       .plan = planIsosurfaces},
      {.name = "outline",
       .description = "the edges of the box around the mesh",
       .wanted = [](const Scene& scene) { return scene.overlays.outline.has_value(); },
       .check = checkOutlineScene,
       .plan = planOutline},
      {.name = "surface",
       .description = "the mesh's boundary faces, opaque or translucent",
       .wanted = [](const Scene& scene) { return scene.overlays.surface.has_value(); },
       .check = checkSurfaceScene,
       .plan = planSurface},
      {.name = "wire frame",
       .description = "the edges of these faces",
       .wanted = [](const Scene& scene) { return scene.overlays.wireFrame.has_value(); },
       .check = checkWireFrameScene,
       .plan = planWireFrame},
  };
  return rows;
}

}  // namespace havs
