// The study in a few lines for people.
#include <fmt/format.h>

#include <algorithm>

#include "study/study_report.h"

namespace havs {
namespace {

std::string describe(const SubjectRecord& subject, const std::vector<ReferenceRecord>& references) {
  std::string text =
      fmt::format("{}: {} tetrahedra, field {}, {}, {}x{}, {} pixels at edges left out\n", subject.id, subject.cells,
                  subject.field, subject.transferFunction, subject.width, subject.height, subject.maskedPixels);
  for (const ReferenceRecord& one : references)
    if (one.subject == subject.id && one.width == subject.width)
      text += fmt::format("  reference drawn in {:.0f} ms\n", one.wallMs);
  return text;
}

std::string row(const RunReport& run) {
  const ErrorMeasures& error = run.quality->error;
  const std::string mark = run.run.kind == RunKind::baseline ? "  (baseline)"
                           : run.run.kind == RunKind::paper  ? "  (paper)"
                                                             : "";
  return fmt::format("  {} {:>9.2f} {:>9.2e} {:>9.2e}  {}{}\n", run.onFront ? '*' : ' ', run.wallMs.median, error.p999,
                     error.max, settingsLabel(run.run.scene), mark);
}

/// The front, and beside it the baseline and the paper's choice.
std::string frontOf(const StudyReport& report, const SubjectRecord& subject) {
  std::vector<const RunReport*> shown;
  for (const RunReport& run : report.runs)
    if (run.run.subject == subject.id && run.quality && run.failed.empty() &&
        (run.onFront || run.run.kind == RunKind::baseline || run.run.kind == RunKind::paper))
      shown.push_back(&run);
  std::stable_sort(shown.begin(), shown.end(), [](auto a, auto b) { return a->wallMs.median < b->wallMs.median; });
  std::string text =
      fmt::format("  {:>11} {:>9} {:>9}  {}\n", "ms a frame", "99.9%", "maximum", "settings (* on the front)");
  for (const RunReport* run : shown) text += row(*run);
  return text;
}

}  // namespace

std::string studyText(const StudyReport& report) {
  std::string text;
  for (const SubjectRecord& subject : report.subjects) {
    text += describe(subject, report.references) + frontOf(report, subject) + effectsText(report, subject.id);
    for (const FitReport& fit : report.fits)
      if (fit.subject == subject.id)
        text += fmt::format("  order of accuracy: {} {}: {:.2f} ({} over {:g} to {:g})\n", fit.lookup, fit.axis,
                            fit.fit.slope, fit.measure, fit.fit.used[0], fit.fit.used[1]);
  }
  for (const RunReport& run : report.runs)
    if (!run.failed.empty()) text += fmt::format("failed: {}: {}\n", run.run.id, run.failed);
  for (const EffectReport& effect : report.effects)
    if (!effect.report.failed.empty())
      text += fmt::format("failed: {}: {}\n", effect.report.run.id, effect.report.failed);
  for (const std::string& reason : report.skipped) text += fmt::format("skipped: {}\n", reason);
  return text;
}

}  // namespace havs
