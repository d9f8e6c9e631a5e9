// For each subject: one round over the baseline, the paper's choice and every axis; from that the combinations worth a
// try; then rounds over all of them, each in an order of its own, so that what drifts favours none.
#include "study/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <set>

#include "core/error.h"
#include "core/output_file.h"
#include "core/parallel.h"
#include "render/devices.h"
#include "render/effects.h"
#include "study/effect_visits.h"
#include "study/fingerprint.h"
#include "study/store.h"
#include "study/subject.h"
#include "study/sweep_plan.h"

namespace havs {
namespace {

namespace fs = std::filesystem;

/// How far the study is, and what is left.
class StudyClock {
 public:
  StudyClock(const Progress& progress, std::size_t visits) : progress_(progress), expected_(visits) {}
  void expect(std::size_t visits) { expected_ = visits; }
  void stored() { ++stored_; }
  void measured() {
    ++measured_;
    if (!progress_) return;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const auto done = static_cast<double>(measured_ + stored_), all = std::max(done, static_cast<double>(expected_));
    const int left = static_cast<int>(seconds / static_cast<double>(measured_) * (all - done));
    progress_(fmt::format("{}:{:02} left", left / 60, left % 60), std::min(0.999, done / all));
  }

 private:
  const Progress& progress_;
  std::size_t expected_, stored_ = 0, measured_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Names of the subjects: the mesh's, and the number of its camera.
std::vector<std::string> subjectIds(const std::vector<Scene>& scenes) {
  std::map<std::string, std::vector<fs::path>> meshes;
  std::map<std::string, int> cameras;
  std::vector<std::string> ids;
  for (const Scene& scene : scenes) {
    std::string stem = fileNameOf(scene.mesh.stem().string());
    auto& named = meshes[stem];
    auto place = std::find(named.begin(), named.end(), scene.mesh);
    if (place == named.end()) place = named.insert(named.end(), scene.mesh);
    if (place != named.begin()) stem += fmt::format("_{}", place - named.begin() + 1);
    ids.push_back(fmt::format("{}-{}", stem, cameras[stem]++));
  }
  return ids;
}

StudyIdentity identityOf(const StudyRequest& request) {
  StudyIdentity identity{{"command line", request.identity}, {"version of havs", HAVS_VERSION}};
  for (const Scene& scene : request.scenes) identity["content of " + scene.mesh.string()] = fingerprintOf(scene.mesh);
  return identity;
}

class Study {
 public:
  Study(const StudyRequest& request, const Progress& progress, StudyStore& store, const RenderDevice& device)
      : request_(request), store_(store), device_(device), ids_(subjectIds(request.scenes)), clock_(progress, 0) {
    report_.command = request.command;
    report_.axes = request.axes;
    report_.baseline = request.scenes.front();
    report_.device = {device.renderer, device.version};
    if (store.records().device.renderer.empty()) store.add(report_.device);
    report_.machine = thisMachine();
  }

  /// `prepared`: of scene i; `preparing`: the stages of that.
  void measure(std::size_t i, const PreparedScene& prepared, const StageTimes& preparing) {
    const Scene& baseline = request_.scenes[i];
    Subject subject(ids_[i], baseline, prepared, preparing, device_, request_.folder, request_.keepBytes);
    keepSubject(subject.record());
    SweepPlan plan = planSweep(ids_[i], baseline, request_.axes);
    report_.skipped.insert(report_.skipped.end(), plan.skipped.begin(), plan.skipped.end());
    expectVisits(i, plan.runs.size());
    visitAll(subject, plan.runs, 0);
    const std::vector<PlannedRun> combined = combinations(plan);
    visitAll(subject, combined, 0);
    plan.runs.insert(plan.runs.end(), combined.begin(), combined.end());
    for (int round = 1; round < request_.repeat; ++round) visitAll(subject, plan.runs, round);
    if (request_.effects) visitEffects({ids_[i], plan.runs.front(), subject}, prepared);
    runs_.insert(runs_.end(), plan.runs.begin(), plan.runs.end());
  }

  const StudyReport& write(bool complete) {
    const StudyRecords& records = store_.records();
    report_.created = records.created;
    report_.complete = complete;
    report_.subjects = records.subjects;
    report_.references = records.references;
    report_.runs = summarise(runs_, records);
    report_.fits = fitRuns(report_.runs);
    report_.effects = summariseEffects(effectRuns_, report_.runs, records);
    writeWhole("study.json", studyJson(report_));
    writeWhole("study.csv", studyCsv(report_));
    if (request_.effects) writeWhole("effects.csv", effectsCsv(report_));
    return report_;
  }

 private:
  void writeWhole(const char* name, const std::string& text) {
    OutputFile file(request_.folder / name, ErrorKind::running);
    file.write(text);
    file.commit();
  }

  void keepSubject(const SubjectRecord& record) {
    const auto& stored = store_.records().subjects;
    const auto found = std::find_if(stored.begin(), stored.end(), [&](const auto& one) { return one.id == record.id; });
    if (found == stored.end())
      store_.add(record);
    else if (*found != record)
      failInput("its mesh, field, transfer function or camera is not what was measured before", record.id,
                "choose another folder; --restart begins anew");
  }

  /// The visits of all subjects, if all are like this one.
  void expectVisits(std::size_t i, std::size_t runs) {
    const std::size_t ofEffects = request_.effects ? effects().size() : 0;
    const std::size_t one = (runs + request_.combinations + ofEffects) * static_cast<std::size_t>(request_.repeat);
    clock_.expect(one * (request_.scenes.size() - i) + visitsBefore_);
    visitsBefore_ += one;
  }

  /// The best by what the first round has measured: the same again for a study that goes on.
  std::vector<PlannedRun> combinations(const SweepPlan& plan) {
    std::map<std::string, CostError> measured;
    for (const VisitRecord& visit : store_.records().visits)
      if (visit.round == 0 && visit.quality) measured[visit.run] = {visit.wallMs, visit.quality->error.p999};
    return planCombinations(plan, request_.axes, measured, request_.combinations);
  }

  void visitAll(Subject& subject, const std::vector<PlannedRun>& runs, int round) {
    std::vector<const PlannedRun*> order;
    for (const PlannedRun& run : runs) order.push_back(&run);
    // std::shuffle may differ from library to library; this must not.
    std::mt19937_64 random(request_.seed * 1000003 + static_cast<std::uint64_t>(round));
    for (std::size_t left = order.size(); left > 1; --left) std::swap(order[left - 1], order[random() % left]);
    for (const PlannedRun* run : order) visit(subject, *run, round);
  }

  void visitEffects(const EffectSubject& baseline, const PreparedScene& prepared) {
    const EffectData data{prepared.curve.domain, prepared.frame.center};
    const SweepPlan effects = measureEffects(request_, baseline, data, device_, store_,
                                             [&](bool measured) { measured ? clock_.measured() : clock_.stored(); });
    report_.skipped.insert(report_.skipped.end(), effects.skipped.begin(), effects.skipped.end());
    effectRuns_.insert(effectRuns_.end(), effects.runs.begin(), effects.runs.end());
  }

  void visit(Subject& subject, const PlannedRun& run, int round) {
    bool done = false, before = false;
    for (const VisitRecord& visit : store_.records().visits)
      if (visit.run == run.id) {
        before = true;
        done = done || visit.round == round || !visit.failed.empty();
      }
    if (done) {
      clock_.stored();
      return;
    }
    const VisitRecord record = subject.visit(run, round, !before);
    for (const ReferenceRecord& reference : subject.references()) store_.addIfNew(reference);
    store_.add(record);
    clock_.measured();
  }

  const StudyRequest& request_;
  StudyStore& store_;
  const RenderDevice& device_;
  std::vector<std::string> ids_;
  StudyClock clock_;
  std::size_t visitsBefore_ = 0;
  std::vector<PlannedRun> runs_, effectRuns_;
  StudyReport report_;
};

bool sameMesh(const Scene& a, const Scene& b) { return a.mesh == b.mesh; }

}  // namespace

StudyReport runStudy(const StudyRequest& request, const Progress& progress) {
  if (request.scenes.empty()) failInput("there is no mesh to study");
  const ThreadLimit limit(request.scenes.front().threads);
  const StudyIdentity identity = identityOf(request);
  StageTimes stages;
  PreparedScene prepared = prepareScene(request.scenes.front(), stages);
  viewOf(request.scenes.front(), prepared);
  StudyStore store(request.folder, identity, request.restart);
  const RenderDevice device = openRenderDevice(request.scenes.front().device, request.scenes.front().threads);
  Study study(request, progress, store, device);
  for (std::size_t i = 0; i < request.scenes.size(); ++i) {
    if (i > 0 && !sameMesh(request.scenes[i], request.scenes[i - 1])) {
      prepared = {};
      stages = {};
      prepared = prepareScene(request.scenes[i], stages);
    }
    study.measure(i, prepared, stages);
    if (i + 1 < request.scenes.size()) study.write(false);
  }
  StudyReport report = study.write(true);
  if (progress) progress("done", 1.0);
  return report;
}

}  // namespace havs
