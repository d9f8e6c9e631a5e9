#include "study/effect_visits.h"

#include <optional>

#include "core/error.h"
#include "study/effect_runs.h"

namespace havs {
namespace {

/// The scene of one run, made ready.
struct Changed {
  StageTimes preparing;
  PreparedScene prepared;
  Subject subject;

  Changed(const PlannedRun& run, const StudyRequest& request, const RenderDevice& device)
      : prepared(prepareScene(run.scene, preparing)),
        subject(run.id, run.scene, prepared, preparing, device, request.folder, request.keepBytes) {}
};

/// What the store holds of a run.
struct Held {
  std::vector<bool> rounds;
  bool any = false, failed = false;
};

Held heldOf(const StudyStore& store, const PlannedRun& run, int rounds) {
  Held held{std::vector<bool>(static_cast<std::size_t>(rounds)), false, false};
  for (const VisitRecord& visit : store.records().visits) {
    if (visit.run != run.id) continue;
    held.any = true;
    held.failed = held.failed || !visit.failed.empty();
    if (visit.round < rounds) held.rounds[static_cast<std::size_t>(visit.round)] = true;
  }
  return held;
}

VisitRecord visitBeside(const EffectSubject& baseline, Changed& changed, const PlannedRun& run, int round,
                        bool withQuality) {
  try {
    std::optional<FrameTime> beside;
    if (round % 2 == 0) beside = baseline.subject.time(baseline.run);
    VisitRecord record = changed.subject.visit(run, round, withQuality);
    if (!record.failed.empty()) return record;
    record.baseline = beside ? *beside : baseline.subject.time(baseline.run);
    return record;
  } catch (const Error& error) {
    return {.run = run.id, .round = round, .failed = std::string("the default: ") + error.what()};
  }
}

/// False where the scene cannot be prepared: `why`.
bool measure(const StudyRequest& request, const EffectSubject& baseline, const PlannedRun& run,
             const RenderDevice& device, StudyStore& store, const std::function<void(bool)>& visited,
             std::string& why) {
  Held held = heldOf(store, run, request.repeat);
  std::optional<Changed> changed;
  for (int round = 0; round < request.repeat; ++round) {
    const bool done = held.failed || held.rounds[static_cast<std::size_t>(round)];
    if (!done) {
      try {
        if (!changed) changed.emplace(run, request, device);
      } catch (const Error& error) {
        if (error.kind() != ErrorKind::input) throw;
        why = error.what();
        return false;
      }
      const VisitRecord record = visitBeside(baseline, *changed, run, round, !held.any);
      for (const ReferenceRecord& reference : changed->subject.references()) store.addIfNew(reference);
      store.add(record);
      held.any = true;
      held.failed = !record.failed.empty();
    }
    visited(!done);
  }
  return true;
}

}  // namespace

SweepPlan measureEffects(const StudyRequest& request, const EffectSubject& baseline, const EffectData& data,
                         const RenderDevice& device, StudyStore& store,
                         const std::function<void(bool measured)>& visited) {
  SweepPlan planned = planEffects(baseline.id, baseline.run.scene, data);
  SweepPlan measured{{}, planned.skipped};
  for (const PlannedRun& run : planned.runs) {
    std::string why;
    if (measure(request, baseline, run, device, store, visited, why))
      measured.runs.push_back(run);
    else
      measured.skipped.push_back(run.id + ": " + why);
  }
  return measured;
}

}  // namespace havs
