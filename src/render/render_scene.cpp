#include "render/render_scene.h"

#include <fmt/format.h>

#include <chrono>
#include <optional>

#include "core/error.h"
#include "core/memory.h"
#include "core/memory_budget.h"
#include "core/parallel.h"
#include "reference/edge_mask.h"
#include "render/devices.h"
#include "render/k_search.h"
#include "render/make_renderer.h"
#include "render/native/instruction_sets.h"
#include "render/order_advice.h"
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
  report.isosurfaces = prepared.isosurfaces;
}

void describePlan(const RenderPlan& chosen, RenderReport& report) {
  report.plan = chosen.items;
  report.lookup = chosen.lookup.name;
  report.tableSize = chosen.tableSize;
  report.k = chosen.k;
  report.ordering = chosen.ordering;
  report.bytesPerPixel = static_cast<std::size_t>(chosen.bytesPerPixel);
  report.targetBytes =
      report.bytesPerPixel * static_cast<std::size_t>(chosen.tileWidth) * static_cast<std::size_t>(chosen.tileHeight);
}

/// Tables, buffers and targets, as the plan foresees them.
void needMemoryOf(const RenderPlan& chosen) {
  double bytes = 0;
  for (const PlanItem& item : chosen.items) bytes += static_cast<double>(item.bytes);
  needMemory(bytes, "drawing", "", "try a smaller --size, --table or --k; havs plan says what needs how much");
}

/// The scene with the k of the search, where it asks for one.
Scene withChosenK(const Scene& scene, const PreparedScene& prepared, const View& view, const Capabilities& capabilities,
                  StageTimes& stages, const Progress& progress) {
  Scene chosen = scene;
  if (!wantsKSearch(scene)) return chosen;
  const ScopedStage timer(stages, "k_search");
  chosen.k = searchK(scene, prepared, view, capabilities, progress);
  chosen.kAuto = false;
  chosen.certificate = true;  // the picture itself proves the choice
  return chosen;
}

void noteUnmendedOrder(const Scene& scene, RenderReport& report) {
  if (!wantsKSearch(scene) || !report.certificate || report.certificate->misordered == 0) return;
  const std::string advice = orderAdvice(scene, report.k);
  report.notes.push_back(fmt::format("no k is enough: with the largest, {}, {} fragments in {} pixels are misordered{}",
                                     report.k, report.certificate->misordered, report.certificate->pixels,
                                     advice.empty() ? "" : "; try " + advice));
}

/// Scene::repeat times; the picture is the last.
void drawRepeatedly(Renderer& renderer, const Scene& scene, const View& view, RenderReport& report,
                    const Progress& progress) {
  for (int i = 0; i < scene.repeat; ++i) {
    if (progress && scene.repeat > 1) progress("drawing", static_cast<double>(i) / scene.repeat);
    Drawing drawing = renderer.draw(view, report.stages, scene.repeat > 1 ? Progress{} : progress);
    report.image = std::move(drawing.image);
    report.certificate = std::move(drawing.certificate);
    report.cycles = drawing.cycles;
    report.tiles = drawing.tiles;
    report.fragments = drawing.fragments;
    report.fragmentBytes = drawing.fragmentBytes;
    report.drawnCells = drawing.drawnCells.value_or(report.cells);
  }
  if (progress && scene.repeat > 1) progress("drawing", 1.0);
}

/// What every way of drawing a scene goes through; draw(prepared, view, report) is its own. `ready`: the scene
/// prepared, where it is already.
template <class Draw>
RenderReport reportOf(const Scene& scene, const Progress& progress, const Draw& draw,
                      const PreparedScene* ready = nullptr, const StageTimes& before = {}) {
  RenderReport report;
  report.stages = before;
  const double cpuBefore = cpuSeconds();
  const auto start = std::chrono::steady_clock::now();
  {
    checkScene(scene);
    const ThreadLimit limit(scene.threads);
    std::optional<PreparedScene> own;
    if (ready == nullptr) own = prepareScene(scene, report.stages, progress);
    const PreparedScene& prepared = ready != nullptr ? *ready : *own;
    describePrepared(prepared, report);
    const View view = viewOf(scene, prepared);
    report.camera = describe(scene.camera, prepared.frame, scene.width, scene.height);
    draw(prepared, view, report);
  }
  double total = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  for (const auto& [stage, milliseconds] : before.medians()) total += milliseconds;
  report.stages.add("total", total);
  report.cpuMilliseconds = 1e3 * (cpuSeconds() - cpuBefore);
  return report;
}

/// Draws through a row of visibilityMethods(): pictures of one scene by one renderer, where that can be.
class SceneDrawer {
 public:
  explicit SceneDrawer(const Progress& progress) : progress_(progress) {}

  void draw(const Scene& scene, const PreparedScene& prepared, const View& view, RenderReport& report) {
    if (!device_) device_.emplace(openRenderDevice(scene.device, scene.threads));
    if (!renderer_ || wantsKSearch(scene)) {
      const Capabilities& capabilities = device_->capabilities;
      renderer_.reset();
      chosen_ = plan(withChosenK(scene, prepared, view, capabilities, report.stages, progress_), prepared.facts(),
                     capabilities);
      needMemoryOf(chosen_);
      renderer_ = makeRenderer(prepared, chosen_, report.stages, progress_);
    }
    describePlan(chosen_, report);
    report.renderer = chosen_.native ? describe(instructionSet(chosen_.instructionSet)) : device_->renderer;
    report.glVersion = device_->version;
    drawRepeatedly(*renderer_, scene, view, report, progress_);
    noteUnmendedOrder(scene, report);
  }

 private:
  const Progress& progress_;
  std::optional<RenderDevice> device_;
  RenderPlan chosen_;
  std::unique_ptr<Renderer> renderer_;  // before its device goes
};

/// The ground truth, by one renderer.
class ReferenceDrawer {
 public:
  ReferenceDrawer(bool edgeMask, const Progress& progress) : edgeMask_(edgeMask), progress_(progress) {}

  void draw(const Scene& scene, const PreparedScene& prepared, const View& view, RenderReport& report) {
    report.reference = true;
    if (!renderer_) renderer_ = makeReference(scene, prepared);
    drawRepeatedly(*renderer_, scene, view, report, progress_);
    if (edgeMask_) report.edgeMask = boundaryEdgeMask(prepared.points, prepared.faces, view);
  }

 private:
  bool edgeMask_;
  const Progress& progress_;
  std::unique_ptr<Renderer> renderer_;
};

/// Of pictures that differ by the camera alone. A drawer's renderer must go before what it draws.
template <class MakeDrawer>
std::vector<RenderReport> reportsOf(std::span<const Scene> scenes, const Progress& progress,
                                    const MakeDrawer& makeDrawer) {
  std::vector<RenderReport> reports;
  if (scenes.size() == 1) {
    reports.push_back(reportOf(scenes[0], progress, [&](const PreparedScene& prepared, const View& view, auto& report) {
      makeDrawer().draw(scenes[0], prepared, view, report);
    }));
    return reports;
  }
  checkScene(scenes[0]);
  const ThreadLimit limit(scenes[0].threads);
  StageTimes before;
  const PreparedScene prepared = prepareScene(scenes[0], before, progress);
  auto drawer = makeDrawer();
  for (const Scene& scene : scenes) {
    const auto draw = [&](const PreparedScene& ready, const View& view, RenderReport& report) {
      drawer.draw(scene, ready, view, report);
    };
    reports.push_back(reportOf(scene, progress, draw, &prepared, reports.empty() ? before : StageTimes{}));
  }
  return reports;
}

}  // namespace

RenderReport renderScene(const Scene& scene, const Progress& progress) {
  return std::move(renderScenes({&scene, 1}, progress)[0]);
}

RenderReport renderScene(const Scene& scene, const PreparedScene& prepared, const StageTimes& before,
                         const Progress& progress) {
  const auto draw = [&](const PreparedScene& ready, const View& view, RenderReport& report) {
    SceneDrawer(progress).draw(scene, ready, view, report);
  };
  return reportOf(scene, progress, draw, &prepared, before);
}

std::vector<RenderReport> renderScenes(std::span<const Scene> scenes, const Progress& progress) {
  return reportsOf(scenes, progress, [&] { return SceneDrawer(progress); });
}

RenderPlan planScene(const Scene& scene, const Progress& progress) {
  checkScene(scene);
  const ThreadLimit limit(scene.threads);
  StageTimes ignored;
  const PreparedScene prepared = prepareScene(scene, ignored, progress);
  const RenderDevice device = openRenderDevice(scene.device, scene.threads);
  return plan(scene, prepared.facts(), device.capabilities);
}

RenderReport drawReference(const Scene& scene, bool edgeMask, const Progress& progress) {
  return std::move(drawReferences({&scene, 1}, edgeMask, progress)[0]);
}

std::vector<RenderReport> drawReferences(std::span<const Scene> scenes, bool edgeMask, const Progress& progress) {
  return reportsOf(scenes, progress, [&] { return ReferenceDrawer(edgeMask, progress); });
}

}  // namespace havs
