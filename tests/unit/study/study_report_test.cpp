#include "study/study_report.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "render/plan.h"
#include "study/sweep_plan.h"

namespace havs {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A study of made figures: three timings of each run, the error that of a second-order table.
class MadeStudy : public testing::Test {
 protected:
  MadeStudy() {
    const std::vector<std::string> axisTexts{"k=1,6", "table=16,32,64,128"};
    report.axes = chooseAxes(axisTexts, false);
    report.command = "havs study \"a\".vtu";
    report.baseline.lookup = "3d";
    plan = planSweep("a-0", report.baseline, report.axes);
    records.subjects = report.subjects = {
        {"a-0", "a.vtu", "abcd", 4, 1, 4, "density", "viridis", R"({"eye":[0,0,1]})", 1024, 1024, 7}};
    records.references = report.references = {{"a-0", 1024, 1024, "images/r.png", 12.5, 25}};
    for (const PlannedRun& run : plan.runs)
      for (int round = 0; round < 3; ++round) records.visits.push_back(visitOf(run, round));
    summarised();
  }

  static VisitRecord visitOf(const PlannedRun& run, int round) {
    const double order[] = {5, 1, 3};
    VisitRecord record{.run = run.id, .round = round, .wallMs = run.scene.k + order[round], .cpuMs = 2};
    if (round > 0) return record;
    record.tableMs = 100;
    record.quality = Quality{};
    const double error = std::pow(tableSizeOf(run.scene), -2.0);
    record.quality->error = {error, 2 * error, 3 * error, 40, 1};
    return record;
  }

  void summarised() {
    report.runs = summarise(plan.runs, records);
    report.fits = fitRuns(report.runs);
  }

  const RunReport& run(const std::string& id) const {
    for (const RunReport& one : report.runs)
      if (one.run.id == id) return one;
    throw std::runtime_error("no run " + id);
  }

  SweepPlan plan;
  StudyRecords records;
  StudyReport report;
};

TEST_F(MadeStudy, GivesMedianAndSpread) {
  const RunReport& one = run("a-0/k=1");
  EXPECT_EQ(one.repetitions, 3);
  EXPECT_EQ(one.wallMs.median, 4);
  EXPECT_EQ(one.wallMs.least, 2);
  EXPECT_EQ(one.wallMs.most, 6);
  EXPECT_EQ(one.tableMs, 100);
}

TEST_F(MadeStudy, MarksTheFront) {
  EXPECT_TRUE(run("a-0/k=1").onFront);        // cheapest, and none errs less
  EXPECT_FALSE(run("a-0/baseline").onFront);  // as wrong, but dearer
  EXPECT_FALSE(run("a-0/table=16").onFront);
}

TEST_F(MadeStudy, FitsTheOrderOfTheTable) {
  ASSERT_EQ(report.fits.size(), 1u);
  EXPECT_EQ(report.fits[0].axis, "table");
  EXPECT_EQ(report.fits[0].lookup, "3d");
  EXPECT_NEAR(report.fits[0].fit.slope, -2, 1e-12);
  EXPECT_THAT(report.fits[0].fit.used, ElementsAre(16, 128));
  EXPECT_EQ(report.fits[0].points.size(), 4u);
}

TEST_F(MadeStudy, KeepsAFailedRunOffTheFrontAndTheFit) {
  for (VisitRecord& visit : records.visits)
    if (visit.run == "a-0/k=1") visit = {.run = visit.run, .round = 0, .failed = "no memory"};
  summarised();
  EXPECT_EQ(run("a-0/k=1").failed, "no memory");
  EXPECT_FALSE(run("a-0/k=1").onFront);
  EXPECT_TRUE(run("a-0/baseline").onFront);
  const auto json = nlohmann::json::parse(studyJson(report));
  for (const auto& one : json["runs"])
    if (one["id"] == "a-0/k=1") {
      EXPECT_EQ(one["failed"], "no memory");
      EXPECT_FALSE(one.contains("error"));
    }
  EXPECT_THAT(studyText(report), HasSubstr("failed: a-0/k=1: no memory"));
}

TEST_F(MadeStudy, IsJsonWithEveryKeyThatThePageReads) {
  const auto json = nlohmann::json::parse(studyJson(report));
  for (const char* key :
       {"version", "command", "created", "complete", "machine", "subjects", "axes", "runs", "fits", "effects"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["command"], "havs study \"a\".vtu");
  EXPECT_EQ(json["subjects"][0]["reference"]["wall_ms"], 12.5);
  EXPECT_EQ(json["subjects"][0]["camera"]["eye"][2], 1);
  EXPECT_EQ(json["axes"][0]["baseline"], "6");
  EXPECT_EQ(json["runs"].size(), plan.runs.size());
  for (const auto& one : json["runs"]) {
    for (const char* key : {"id", "subject", "kind", "axis", "value", "label", "settings", "error",
                            "error_with_masked_pixels", "certificate", "repetitions", "frame_wall_ms", "frame_cpu_ms",
                            "table_ms", "bytes_per_pixel", "image", "difference", "on_front", "failed"})
      EXPECT_TRUE(one.contains(key)) << key;
    for (const char* key :
         {"visibility", "k", "sort", "lookup", "table", "table_format", "early_termination", "composite_late", "size"})
      EXPECT_TRUE(one["settings"].contains(key)) << key;
    EXPECT_TRUE(one["failed"].is_null());
  }
}

/// A reader of CSV after RFC 4180.
std::vector<std::vector<std::string>> parseCsv(const std::string& text) {
  std::vector<std::vector<std::string>> rows{{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (quoted) {
      if (text[i] != '"')
        rows.back().back() += text[i];
      else if (i + 1 < text.size() && text[i + 1] == '"')
        rows.back().back() += text[i++];
      else
        quoted = false;
    } else if (text[i] == '"') {
      quoted = true;
    } else if (text[i] == ',') {
      rows.back().emplace_back();
    } else if (text[i] == '\n') {
      rows.push_back({""});
    } else {
      rows.back().back() += text[i];
    }
  }
  rows.pop_back();
  return rows;
}

TEST_F(MadeStudy, IsCsvWithARowForEachRun) {
  for (VisitRecord& visit : records.visits)
    if (visit.run == "a-0/k=1") visit = {.run = visit.run, .round = 0, .failed = "say \"no\", twice"};
  summarised();
  const auto rows = parseCsv(studyCsv(report));
  ASSERT_EQ(rows.size(), 1 + plan.runs.size());
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), name) - rows[0].begin());
  };
  for (const auto& row : rows) ASSERT_EQ(row.size(), rows[0].size());
  ASSERT_LT(column("error.p999"), rows[0].size());
  ASSERT_LT(column("frame_wall_ms.median"), rows[0].size());
  for (const auto& row : rows) {
    if (row[column("id")] == "a-0/baseline") {
      EXPECT_EQ(std::stod(row[column("error.p999")]), 2.0 / (128 * 128));
      EXPECT_EQ(row[column("label")], "kbuffer k 6, topological, 3d 128^3 rgba32f");
      EXPECT_EQ(row[column("settings.size")], "1024x1024");
    }
    if (row[column("id")] == "a-0/k=1") {
      EXPECT_EQ(row[column("failed")], "say \"no\", twice");
    }
  }
}

TEST_F(MadeStudy, IsTextWithFrontAndOrder) {
  const std::string text = studyText(report);
  EXPECT_THAT(text, HasSubstr("* "));
  EXPECT_THAT(text, HasSubstr("(baseline)"));
  EXPECT_THAT(text, HasSubstr("(paper)"));
  EXPECT_THAT(text, HasSubstr("3d table: -2.00 (rmse over 16 to 128)"));
}

}  // namespace
}  // namespace havs
