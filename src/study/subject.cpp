#include "study/subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cmath>

#include "core/error.h"
#include "image/difference_picture.h"
#include "reference/edge_mask.h"
#include "render/effects.h"
#include "render/make_renderer.h"
#include "study/axes.h"
#include "study/fingerprint.h"
#include "study/timed_draw.h"
#include "transfer/transfer_function.h"

namespace havs {

/// A renderer just made, and what it cost.
struct Subject::Made {
  std::unique_ptr<Renderer> renderer;
  RenderPlan plan;
  StageTimes stages;
  double makeMs = 0;
};

/// A drawing, and how its renderer was made where that was needed.
struct Subject::Visited {
  TimedDrawing timed;
  Made made;
  StageTimes firstPicture;  ///< of a renderer just made: one that is not timed comes first
};

namespace {

/// What a renderer holds, at most, roughly: targets, fragments, table, vertices and faces.
std::size_t bytesOf(const RenderPlan& plan, const PreparedScene& prepared) {
  const double targets = static_cast<double>(plan.bytesPerPixel) * plan.tileWidth * plan.tileHeight;
  const LookupResource* resource = tableOf(plan.lookup);
  const double entries = resource != nullptr ? std::pow(plan.tableSize, resource->axes) : 0;
  const double table = static_cast<double>(plan.tableFormat.bytesPerEntry) * entries;
  const double mesh =
      16.0 * static_cast<double>(prepared.points.size()) + 32.0 * static_cast<double>(prepared.faces.size());
  const double fragments = 16.0 * static_cast<double>(plan.mostFragments);
  return static_cast<std::size_t>(targets + fragments + table + mesh);
}

SubjectRecord describeSubject(std::string id, const Scene& scene, const PreparedScene& prepared) {
  SubjectRecord record;
  record.id = std::move(id);
  record.mesh = scene.mesh.filename().string();
  record.content = fingerprintOf(prepared);
  record.points = prepared.points.size();
  record.cells = prepared.mesh.tetrahedra.size();
  record.faces = prepared.faces.size();
  record.field = prepared.field.name;
  record.transferFunction = prepared.transferFunction;
  record.camera = describe(scene.camera, prepared.frame, scene.width, scene.height);
  record.width = scene.width;
  record.height = scene.height;
  const auto mask = boundaryEdgeMask(prepared.points, prepared.faces, viewOf(scene, prepared));
  record.maskedPixels = static_cast<std::size_t>(std::count(mask.begin(), mask.end(), 1));
  return record;
}

/// On one scale for all runs, from 1e-7 to 1, so that their pictures can be compared by eye.
Image differenceOf(const Image& image, const Truth& truth) {
  return differencePicture(image, truth.image, truth.mask, {.colors = presetColors("inferno"), .max = 1.0}).image;
}

constexpr std::array kOncePrepared{"prepare", "faces"};  ///< stages of prepareScene after reading
constexpr const char* kReadback = "readback";            ///< not part of a frame

bool has(const StageTimes& stages, const std::string& stage) {
  const auto all = stages.medians();
  return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.first == stage; });
}

/// Adds stages that `later` has not.
void addStages(StageMilliseconds& to, const StageTimes& stages, const StageTimes& later) {
  for (const auto& [stage, median] : stages.medians())
    if (stage != kReadback && !has(later, stage)) to.emplace_back(stage, stages.total(stage));
}

double sumOf(const StageMilliseconds& stages) {
  double sum = 0;
  for (const auto& [stage, milliseconds] : stages) sum += milliseconds;
  return sum;
}

/// A lookup without a table to be made.
std::string cheapestLookup() {
  for (const Lookup& row : lookups())
    if (tableOf(row) == nullptr) return exampleName(row);
  return exampleName(lookups().front());
}

/// The scene with a certificate, and without what costs time but does not change which fragments come late: tables
/// (but for early termination, which ends pixels by their opacity) and light.
Scene sceneToCertify(Scene scene) {
  scene.certificate = true;
  if (scene.earlyTermination > 0) return scene;
  scene.lookup = cheapestLookup();
  for (const Effect& effect : effects())
    if (effect.light != nullptr && effect.remove != nullptr && effect.wanted(scene)) effect.remove(scene);
  return scene;
}

}  // namespace

std::string fileNameOf(const std::string& runId) {
  std::string name = runId;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && std::string("=,.-").find(c) == std::string::npos) c = '_';
  return name;
}

Subject::Subject(std::string id, const Scene& baseline, const PreparedScene& prepared, const StageTimes& preparing,
                 const RenderDevice& device, std::filesystem::path folder, std::size_t keepBytes)
    : prepared_(prepared),
      preparing_(preparing),
      device_(device),
      folder_(std::move(folder)),
      record_(describeSubject(std::move(id), baseline, prepared)),
      truths_(record_.id, prepared, folder_),
      pool_(keepBytes) {}

Subject::Made Subject::make(const Scene& scene) const {
  using Clock = std::chrono::steady_clock;
  Made made;
  const auto start = Clock::now();
  made.plan = plan(scene, prepared_.facts(), device_.capabilities);
  made.renderer = makeRenderer(prepared_, made.plan, made.stages);
  made.makeMs = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  return made;
}

std::optional<std::array<std::size_t, 2>> Subject::certificateOf(const Scene& scene) {
  const Scene asked = sceneToCertify(scene);
  const auto [found, isNew] = certificates_.try_emplace(settingsKey(asked), std::nullopt);
  if (isNew) {
    try {
      StageTimes stages;
      const Drawing drawing = make(asked).renderer->draw(viewOf(asked, prepared_), stages);
      if (drawing.certificate) found->second = {drawing.certificate->misordered, drawing.certificate->pixels};
    } catch (const Error&) {  // this machine cannot count with these settings
    }
  }
  return found->second;
}

Subject::Visited Subject::draw(const PlannedRun& run) {
  Visited visited;
  const View view = viewOf(run.scene, prepared_);
  Renderer* renderer = pool_.find(run.id);
  if (renderer == nullptr) {
    visited.made = make(run.scene);
    renderer = visited.made.renderer.get();
    renderer->draw(view, visited.firstPicture);
  }
  visited.timed = drawTimed(*renderer, view);
  return visited;
}

FrameTime Subject::time(const PlannedRun& run) {
  Visited visited = draw(run);
  Made& made = visited.made;
  if (made.renderer) pool_.offer(run.id, std::move(made.renderer), bytesOf(made.plan, prepared_), made.makeMs);
  return {visited.timed.wallMs, visited.timed.cpuMs};
}

VisitRecord Subject::visit(const PlannedRun& run, int round, bool withQuality) {
  VisitRecord record{.run = run.id, .round = round};
  Image image, difference;
  try {
    Visited visited = draw(run);
    Made& made = visited.made;
    record.wallMs = visited.timed.wallMs;
    record.cpuMs = visited.timed.cpuMs;
    if (made.renderer) {
      record.tableMs = made.stages.total("table");
      for (const char* stage : kOncePrepared) record.stagesMs.emplace_back(stage, preparing_.total(stage));
      addStages(record.stagesMs, made.stages, visited.timed.stages);
      addStages(record.stagesMs, visited.firstPicture, visited.timed.stages);
      record.prepareMs = sumOf(record.stagesMs);
    }
    addStages(record.stagesMs, visited.timed.stages, {});
    if (withQuality) {
      const Truth& truth = truths_.of(run.scene);
      image = std::move(visited.timed.drawing.image);
      Quality& quality = record.quality.emplace();
      quality.error = compareImages(image, truth.image, truth.mask).rgba;
      quality.errorWithMasked = compareImages(image, truth.image).rgba;
      difference = differenceOf(image, truth);
      quality.bytesPerPixel = static_cast<std::size_t>(made.plan.bytesPerPixel);
      quality.plan = made.plan.items;
      quality.certificate = certificateOf(run.scene);
    }
    if (made.renderer) pool_.offer(run.id, std::move(made.renderer), bytesOf(made.plan, prepared_), made.makeMs);
  } catch (const std::bad_alloc&) {
    return {.run = run.id, .round = round, .failed = "out of memory"};
  } catch (const std::exception& error) {
    return {.run = run.id, .round = round, .failed = error.what()};
  }
  if (record.quality) {
    const std::string name = "images/" + fileNameOf(run.id);
    record.quality->image = name + ".png";
    record.quality->difference = name + "-difference.png";
    try {
      writeImage(image, folder_ / record.quality->image, {run.scene.background, 8});
      writeImage(difference, folder_ / record.quality->difference);
    } catch (const Error& error) {
      throw Error(ErrorKind::running, error.what());  // the folder was there when the study began
    }
  }
  return record;
}

}  // namespace havs
