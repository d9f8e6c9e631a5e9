#pragma once
#include <functional>
#include <string>
#include <vector>

#include "render/effects.h"
#include "study/store.h"
#include "study/study.h"
#include "study/subject.h"
#include "study/sweep_plan.h"

namespace havs {

/// A subject's baseline, of which a study measures the effects.
struct EffectSubject {
  std::string id;
  const PlannedRun& run;
  Subject& subject;
};

/// Measures every run of planEffects beside the baseline: in each visit the two are drawn one after the other, in turn
/// which first, so that what drifts favours none. Each has a scene of its own, prepared for it. Visits that the store
/// holds are not repeated; `visited`: called after each, whether it was. What cannot be prepared is skipped, with the
/// reason. Returns the runs. Throws Error{running} (disk full, ...).
SweepPlan measureEffects(const StudyRequest& request, const EffectSubject& baseline, const EffectData& data,
                         const RenderDevice& device, StudyStore& store,
                         const std::function<void(bool measured)>& visited);

}  // namespace havs
