// What the records say of each run; fronts and fits.
#include <algorithm>
#include <charconv>
#include <limits>
#include <map>

#include "core/median.h"
#include "render/lookups.h"
#include "render/plan.h"
#include "study/front.h"
#include "study/study_report.h"

namespace havs {
namespace {

/// Medians of each stage over the visits in which it ran.
StageMilliseconds stagesOf(const std::vector<VisitRecord>& visits, const std::string& run) {
  std::vector<std::string> order;
  std::map<std::string, std::vector<double>> values;
  for (const VisitRecord& visit : visits)
    if (visit.run == run)
      for (const auto& [stage, milliseconds] : visit.stagesMs) {
        if (!values.contains(stage)) order.push_back(stage);
        values[stage].push_back(milliseconds);
      }
  StageMilliseconds medians;
  for (const std::string& stage : order) medians.emplace_back(stage, medianOf(values[stage]));
  return medians;
}

struct Measured {
  std::vector<double> wall, cpu, table, prepare;
  std::optional<Quality> quality;
  std::string failed;
};

std::map<std::string, Measured> byRun(const StudyRecords& records) {
  std::map<std::string, Measured> all;
  for (const VisitRecord& visit : records.visits) {
    Measured& one = all[visit.run];
    if (!visit.failed.empty()) {
      one.failed = visit.failed;
      continue;
    }
    one.wall.push_back(visit.wallMs);
    one.cpu.push_back(visit.cpuMs);
    if (visit.tableMs) one.table.push_back(*visit.tableMs);
    if (visit.prepareMs) one.prepare.push_back(*visit.prepareMs);
    if (visit.quality) one.quality = visit.quality;
  }
  return all;
}

/// Runs of one subject and one size are compared with each other; the front is that of the subject's own size.
void markFronts(std::vector<RunReport>& runs) {
  std::map<std::string, std::vector<std::size_t>> groups;
  std::map<std::string, std::pair<int, int>> sizes;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const PlannedRun& run = runs[i].run;
    const std::pair size{run.scene.width, run.scene.height};
    const bool own = sizes.try_emplace(run.subject, size).first->second == size;
    if (own && runs[i].quality && runs[i].failed.empty()) groups[run.subject].push_back(i);
  }
  for (const auto& [subject, members] : groups) {
    std::vector<CostError> points;
    for (const std::size_t i : members) points.push_back({runs[i].wallMs.median, runs[i].quality->error.p999});
    const std::vector<bool> on = nonDominated(points);
    for (std::size_t j = 0; j < members.size(); ++j) runs[members[j]].onFront = on[j];
  }
}

using Points = std::vector<std::array<double, 2>>;

/// Whether two runs differ in nothing but lookup and table size.
bool sameButLookup(Scene a, const Scene& b) {
  a.lookup = b.lookup;
  a.tableSize = b.tableSize;
  a.tableFormat = b.tableFormat;
  return settingsKey(a) == settingsKey(b);
}

/// What the other sources of error leave: the error of the lookup `exact` where it was measured with the same settings.
double floorOf(const std::vector<RunReport>& runs, const PlannedRun& like) {
  for (const RunReport& run : runs)
    if (run.run.subject == like.subject && run.quality && run.run.scene.lookup == "exact" &&
        sameButLookup(run.run.scene, like.scene))
      return run.quality->error.rmse;
  return 0;
}

std::optional<FitReport> fitReport(const std::vector<RunReport>& runs, const PlannedRun& like,
                                   const std::string& axisName, const std::string& lookupName, Points points) {
  std::sort(points.begin(), points.end());
  const auto fit = fitOrder(points, floorOf(runs, like));
  if (!fit) return std::nullopt;
  return FitReport{like.subject, axisName, lookupName, "rmse", std::move(points), *fit};
}

/// Series of runs that differ in a number only: of a table's size, or the n of a lookup "name:n".
struct Series {
  const PlannedRun* like = nullptr;
  std::string axis, lookup;
  Points points;
};

void addTo(std::map<std::string, Series>& series, const std::string& key, const RunReport& run,
           const std::string& axisName, const std::string& lookupName, double size) {
  Series& one = series[key];
  if (one.like == nullptr) one = {&run.run, axisName, lookupName, {}};
  one.points.push_back({size, run.quality->error.rmse});
}

/// Only around the baseline: in combinations other sources of error are greater.
std::map<std::string, Series> seriesOf(const std::vector<RunReport>& runs) {
  std::map<std::string, Series> series;
  for (const RunReport& run : runs) {
    if (!run.quality || !run.failed.empty() || run.run.kind == RunKind::front || run.run.kind == RunKind::paper)
      continue;
    Scene scene = run.run.scene;
    if (axis("table").applies(scene)) {
      scene.tableSize = 0;
      addTo(series, run.run.subject + "|" + settingsKey(scene), run, "table", scene.lookup, tableSizeOf(run.run.scene));
    }
    const std::size_t colon = scene.lookup.find(':');
    if (colon == std::string::npos) continue;
    double samples = 0;
    const std::string number = scene.lookup.substr(colon + 1), name = scene.lookup.substr(0, colon);
    if (std::from_chars(number.data(), number.data() + number.size(), samples).ec != std::errc{}) continue;
    std::string key = run.run.subject + "|" + settingsKey(scene);
    key.replace(key.find(scene.lookup), scene.lookup.size(), name);
    addTo(series, key, run, "lookup", name, samples);
  }
  return series;
}

}  // namespace

Spread spreadOf(const std::vector<double>& values) {
  if (values.empty()) return {};
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {medianOf(values), *least, *most};
}

std::vector<RunReport> summarise(const std::vector<PlannedRun>& runs, const StudyRecords& records) {
  const std::map<std::string, Measured> measured = byRun(records);
  std::vector<RunReport> reports;
  for (const PlannedRun& run : runs) {
    RunReport& report = reports.emplace_back();
    report.run = run;
    const auto found = measured.find(run.id);
    if (found == measured.end()) continue;
    const Measured& one = found->second;
    report.failed = one.failed;
    report.quality = one.quality;
    report.repetitions = static_cast<int>(one.wall.size());
    report.wallMs = spreadOf(one.wall);
    report.cpuMs = spreadOf(one.cpu);
    report.tableMs = spreadOf(one.table).median;
    report.prepareMs = spreadOf(one.prepare).median;
    report.stagesMs = stagesOf(records.visits, run.id);
  }
  markFronts(reports);
  return reports;
}

std::vector<FitReport> fitRuns(const std::vector<RunReport>& runs) {
  std::vector<FitReport> fits;
  for (const auto& [key, series] : seriesOf(runs))
    if (auto fit = fitReport(runs, *series.like, series.axis, series.lookup, series.points))
      fits.push_back(std::move(*fit));
  return fits;
}

}  // namespace havs
