#include "study/store.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "support/temporary_folder.h"

namespace havs {
namespace {

using test::contentOf;
using test::TemporaryFolder;
using testing::HasSubstr;

const StudyIdentity kIdentity{{"command line", "havs study a.vtu"}, {"content of a.vtu", "1234"}};

VisitRecord visitOf(const std::string& run, int round) {
  VisitRecord record{.run = run, .round = round, .wallMs = 1.0 / 3.0 + round, .cpuMs = 2.5};
  record.stagesMs = {{"order", 0.1}, {"draw", 1.0 / 7.0}};
  record.baseline = {0.25 + round, 0.5};
  if (round == 0) {
    record.tableMs = 860.871412;
    record.prepareMs = 12.75;
    Quality& quality = record.quality.emplace();
    quality.error = {1e-7, 2e-5, 0.1, std::numeric_limits<double>::infinity(), std::nan("")};
    quality.errorWithMasked = {1e-6, 3e-5, 1, 120, 0.5};
    quality.certificate = {{17, 3}};
    quality.bytesPerPixel = 64;
    quality.image = "images/a.png";
    PlanItem item;
    item.kind = PlanKind::vertexData;
    item.name = "light of points";
    item.stage = "upload_mesh";
    item.bytes = 1234;
    quality.plan = {item};
  }
  return record;
}

SubjectRecord subject() {
  return {"a-0", "a.vtu", "abcd", 4, 1, 4, "density \xff", "viridis", R"({"eye":[0,0,1]})", 64, 48, 7};
}

class Store : public testing::Test {
 protected:
  StudyStore open(bool restart = false) const { return {folder / "out", kIdentity, restart}; }
  std::filesystem::path file() const { return folder.path() / "out" / "runs.jsonl"; }
  std::string refusal(const StudyIdentity& identity) const {
    try {
      const StudyStore store(folder / "out", identity, false);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      return error.what();
    }
    return "";
  }
  /// A store with a subject and three visits; its text.
  std::string filled() const {
    StudyStore store = open();
    store.add(DeviceRecord{"llvmpipe", "4.5"});
    store.add(subject());
    store.add(ReferenceRecord{"a-0", 64, 48, "images/r.png", 12.5, 25});
    for (int round = 0; round < 3; ++round) store.add(visitOf("a-0/k=2", round));
    return contentOf(file());
  }
  TemporaryFolder folder;
};

TEST_F(Store, GivesBackWhatWasStored) {
  filled();
  const StudyStore store = open();
  const StudyRecords& records = store.records();
  EXPECT_EQ(records.device.renderer, "llvmpipe");
  ASSERT_EQ(records.subjects.size(), 1u);
  SubjectRecord expected = subject();
  expected.field = "density \xef\xbf\xbd";  // a byte that is not UTF-8 cannot be kept
  EXPECT_EQ(records.subjects[0], expected);
  ASSERT_EQ(records.references.size(), 1u);
  EXPECT_EQ(records.references[0].wallMs, 12.5);
  ASSERT_EQ(records.visits.size(), 3u);
  const VisitRecord& first = records.visits[0];
  EXPECT_EQ(first.wallMs, 1.0 / 3.0);  // to the last bit
  EXPECT_EQ(first.tableMs, 860.871412);
  EXPECT_EQ(first.prepareMs, 12.75);
  EXPECT_EQ(first.stagesMs, (StageMilliseconds{{"order", 0.1}, {"draw", 1.0 / 7.0}}));
  EXPECT_EQ(first.baseline->wallMs, 0.25);
  EXPECT_EQ(records.visits[2].baseline->wallMs, 2.25);
  ASSERT_EQ(first.quality->plan.size(), 1u);
  EXPECT_EQ(first.quality->plan[0].kind, PlanKind::vertexData);
  EXPECT_EQ(first.quality->plan[0].name, "light of points");
  EXPECT_EQ(first.quality->plan[0].stage, "upload_mesh");
  EXPECT_EQ(first.quality->plan[0].bytes, 1234u);
  ASSERT_TRUE(first.quality);
  EXPECT_EQ(first.quality->error.p999, 2e-5);
  EXPECT_TRUE(std::isinf(first.quality->error.psnr));
  EXPECT_TRUE(std::isnan(first.quality->error.ssim));
  EXPECT_EQ(first.quality->certificate, (std::array<std::size_t, 2>{17, 3}));
  EXPECT_FALSE(records.visits[1].quality);
  EXPECT_FALSE(records.visits[1].tableMs);
  EXPECT_FALSE(records.visits[1].prepareMs);
}

TEST_F(Store, KeepsWhyARunFailed) {
  {
    StudyStore store = open();
    store.add({.run = "a-0/k=99", .round = 0, .failed = "k is 99"});
  }
  EXPECT_EQ(open().records().visits.at(0).failed, "k is 99");
}

/// Killed while it wrote: whatever was whole is there, and the next record stands on a line of its own.
TEST_F(Store, DropsALineThatIsNotWhole) {
  const std::string text = filled();
  const std::size_t lastLine = text.rfind('\n', text.size() - 2) + 1;
  for (const std::size_t length : {lastLine, lastLine + 1, lastLine + 20, text.size() - 1}) {
    folder.write("out/runs.jsonl", text.substr(0, length));
    {
      StudyStore store = open();
      EXPECT_EQ(store.records().visits.size(), 2u) << length;
      store.add(visitOf("a-0/k=2", 2));
    }
    EXPECT_EQ(contentOf(file()), text) << length;
  }
}

TEST_F(Store, BeginsAnewWhereNotEvenTheFirstLineIsWhole) {
  filled();
  folder.write("out/runs.jsonl", R"({"study":{"versi)");
  EXPECT_TRUE(open().records().visits.empty());
  EXPECT_TRUE(open().records().visits.empty());
}

TEST_F(Store, ForgetsOnRestart) {
  filled();
  EXPECT_TRUE(open(true).records().visits.empty());
  EXPECT_TRUE(open().records().visits.empty());
}

TEST_F(Store, RefusesAnotherStudy) {
  const std::string text = filled();
  EXPECT_THAT(refusal({{"command line", "havs study b.vtu"}, {"content of a.vtu", "1234"}}),
              HasSubstr("another command line"));
  const std::string other = refusal({{"command line", "havs study a.vtu"}, {"content of a.vtu", "99"}});
  EXPECT_THAT(other, HasSubstr("another content of a.vtu"));
  EXPECT_THAT(other, HasSubstr("--restart"));
  EXPECT_EQ(contentOf(file()), text);
}

TEST_F(Store, RefusesADamagedLine) {
  std::string text = filled();
  text[text.find("\"visit\"") + 3] = '"';
  folder.write("out/runs.jsonl", text);
  EXPECT_THAT(refusal(kIdentity), HasSubstr("runs.jsonl:5"));
  folder.write("out/runs.jsonl", "what is this?\n");
  EXPECT_THAT(refusal(kIdentity), HasSubstr("runs.jsonl:1"));
  EXPECT_EQ(contentOf(file()), "what is this?\n");
}

TEST_F(Store, IsHeldByOneAtATime) {
  const StudyStore store = open();
  EXPECT_THAT(refusal(kIdentity), HasSubstr("another study is running there"));
}

TEST_F(Store, RefusesAFolderThatIsAFile) {
  folder.write("out", "a file");
  EXPECT_THAT(refusal(kIdentity), HasSubstr("cannot make the folder"));
}

}  // namespace
}  // namespace havs
