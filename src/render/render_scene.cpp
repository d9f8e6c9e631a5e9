#include "render/render_scene.h"

#include "core/error.h"
#include "core/memory.h"
#include "core/parallel.h"
#include "render/make_renderer.h"
#include "render/plan.h"
#include "scene/prepared_scene.h"

namespace havs {
namespace {

void describePrepared(const PreparedScene& prepared, RenderReport& report) {
  report.points = prepared.points.size();
  report.cells = prepared.mesh.tetrahedra.size();
  report.faces = prepared.faces.size();
  report.boundaryFaces = prepared.faces.boundaryCount;
  report.defects = prepared.defects;
  report.notes = prepared.notes;
  report.field = prepared.field.name;
  report.centering = prepared.field.centering == Centering::cell ? "cell" : "point";
  report.fieldRange = {prepared.field.minimum, prepared.field.maximum};
  report.transferFunction = prepared.transferFunction;
  report.meaning = prepared.meaning;
  report.unitLength = prepared.curve.unitLength;
  report.domain = prepared.curve.domain;
}

void describePlan(const RenderPlan& chosen, RenderReport& report) {
  report.ordering = chosen.ordering;
  report.bytesPerPixel = static_cast<std::size_t>(chosen.bytesPerPixel);
  report.targetBytes =
      report.bytesPerPixel * static_cast<std::size_t>(chosen.tileWidth) * static_cast<std::size_t>(chosen.tileHeight);
}

void refuseCameraInside(const PreparedScene& prepared, const View& view) {
  if (!view.orthographic && insideMesh(prepared, view.eye))
    failInput("the camera is inside the mesh", "camera", "move it out, or look with an orthographic projection");
}

}  // namespace

RenderReport renderScene(const Scene& scene, const Progress& progress) {
  RenderReport report;
  const double cpuBefore = cpuSeconds();
  {
    const ScopedStage total(report.stages, "total");
    checkScene(scene);
    const ThreadLimit limit(scene.threads);
    const PreparedScene prepared = prepareScene(scene, report.stages, progress);
    describePrepared(prepared, report);

    const View view = makeView(scene.camera, prepared.frame, scene.width, scene.height);
    report.camera = describe(scene.camera, prepared.frame, scene.width, scene.height);
    refuseCameraInside(prepared, view);

    const auto device = makeDevice(scene.device, scene.threads);
    report.renderer = device->renderer();
    report.glVersion = device->version();
    const RenderPlan chosen = plan(scene, prepared.facts(), capabilitiesOf(*device));
    describePlan(chosen, report);

    const auto renderer = makeRenderer(prepared, chosen, report.stages, progress);
    for (int i = 0; i < scene.repeat; ++i) {
      if (progress && scene.repeat > 1) progress("drawing", static_cast<double>(i) / scene.repeat);
      Drawing drawing = renderer->draw(view, report.stages, scene.repeat > 1 ? Progress{} : progress);
      report.image = std::move(drawing.image);
      report.certificate = std::move(drawing.certificate);
      report.cycles = drawing.cycles;
      report.tiles = drawing.tiles;
      report.fragments = drawing.fragments;
      report.fragmentBytes = drawing.fragmentBytes;
    }
    if (progress && scene.repeat > 1) progress("drawing", 1.0);
  }
  report.cpuMilliseconds = 1e3 * (cpuSeconds() - cpuBefore);
  return report;
}

}  // namespace havs
