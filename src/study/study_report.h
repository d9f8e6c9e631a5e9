#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "study/axes.h"
#include "study/fit.h"
#include "study/machine.h"
#include "study/records.h"
#include "study/store.h"

namespace havs {

/// Median, least and greatest of repeated measurements.
struct Spread {
  double median = 0, least = 0, most = 0;
};

/// Of no values: zeros.
Spread spreadOf(const std::vector<double>& values);

/// A run and all that was measured of it.
struct RunReport {
  PlannedRun run;
  std::optional<Quality> quality;  ///< none: not measured (yet), or failed
  int repetitions = 0;
  Spread wallMs, cpuMs;        ///< of a frame
  double prepareMs = 0;        ///< VisitRecord::prepareMs; median
  StageMilliseconds stagesMs;  ///< VisitRecord::stagesMs; medians
  double tableMs = 0;          ///< to make the table; median
  bool onFront = false;  ///< of its subject, by median wall time and 99.9th percentile, among pictures of one size
  std::string failed;    ///< why
};

/// A run of an effect beside the baseline.
struct EffectReport {
  RunReport report;
  RunReport baseline;                        ///< of the same subject
  std::optional<ReferenceRecord> reference;  ///< the ground truth with the change
  Spread baselineWallMs, baselineCpuMs;      ///< of the frames drawn beside it
  Spread wallRatio, cpuRatio;                ///< of a frame with the effect to one without, of each visit
};

/// How the error falls with the size of a table, or with the samples of a segment.
struct FitReport {
  std::string subject, axis, lookup, measure;
  std::vector<std::array<double, 2>> points;  ///< size, error; ascending
  OrderFit fit;
};

/// Everything that study.json holds.
struct StudyReport {
  std::string command, created;
  bool complete = false;
  Machine machine;
  DeviceRecord device;
  std::vector<SubjectRecord> subjects;
  std::vector<ReferenceRecord> references;
  std::vector<AxisChoice> axes;
  Scene baseline;  ///< of the first subject
  std::vector<RunReport> runs;
  std::vector<FitReport> fits;
  std::vector<EffectReport> effects;
  std::vector<std::string> skipped;  ///< what was not measured, and why
};

/// The runs with what the records say of them, their fronts and their fits.
std::vector<RunReport> summarise(const std::vector<PlannedRun>& runs, const StudyRecords& records);
std::vector<FitReport> fitRuns(const std::vector<RunReport>& runs);
/// `effects`: runs of effects; `runs`: the others.
std::vector<EffectReport> summariseEffects(const std::vector<PlannedRun>& effects, const std::vector<RunReport>& runs,
                                           const StudyRecords& records);
/// What the run's plan keeps, as foreseen.
std::size_t plannedBytes(const RunReport& run);

/// study.json, docs/01-start.md.
std::string studyJson(const StudyReport& report);
/// One row a run, with a header; missing values are empty.
std::string studyCsv(const StudyReport& report);
/// One row an effect, with a header, as studyCsv.
std::string effectsCsv(const StudyReport& report);
/// What each effect of a subject costs: one row an effect; empty where none was measured.
std::string effectsText(const StudyReport& report, const std::string& subject);
/// The fronts as tables, what effects cost, the fits, what failed and what was skipped, for people.
std::string studyText(const StudyReport& report);

}  // namespace havs
