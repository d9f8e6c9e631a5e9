#pragma once
// What a study draws to tell what each effect costs (`havs study --effects`).
#include <string>

#include "render/effects.h"
#include "study/sweep_plan.h"

namespace havs {

/// For each row of effects() (render/effects.h) one run: the baseline without it where the baseline has it, else the
/// baseline with its default form. What cannot be drawn so is in SweepPlan::skipped, with the reason.
SweepPlan planEffects(const std::string& subject, const Scene& baseline, const EffectData& data);

/// "with shadows and lighting", "without lighting".
std::string effectLabel(const PlannedRun& run);

}  // namespace havs
