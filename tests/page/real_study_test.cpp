// A study as the program makes it, from the command line to its page in a browser: what the two halves agree on.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <set>

#include "cli/run_havs.h"
#include "cli/sample_files.h"
#include "page/chromium.h"
#include "study/page_pictures.h"

namespace havs::test {
namespace {

using Json = nlohmann::json;

const std::vector<std::string> kArguments{
    "study",  "cube.node",  "--out",    "out",    "--size",
    "40x30",  "--axis",     "k=1,6",    "--axis", "lookup=3d,2d,3d-normalised,exact",
    "--axis", "table=8,64", "--repeat", "2",      "--combinations",
    "2",      "--quiet"};

/// Six tetrahedra, pictures of a few pixels. One test, as each test is a process that would make the study again.
class RealStudy : public testing::Test {
 protected:
  void SetUp() override {
    if (!Chromium::isInstalled()) GTEST_SKIP() << "no Chromium to open the page with; Debian: apt install chromium";
    writeTetgenMesh(folder_, "cube", kCubeNode, kCubeEle);
    const Outcome run = runHavs(kArguments, folder_.path());
    ASSERT_EQ(run.status, 0) << run.error;
    study_ = Json::parse(contentOf(folder_ / "out/study.json"));
    chromium_ = std::make_unique<Chromium>();
    chromium_->open(page());
  }

  std::filesystem::path page() const { return folder_ / "out/report.html"; }
  Json js(const std::string& expression) { return chromium_->evaluate(expression); }

  std::vector<Json> runsThat(const std::function<bool(const Json&)>& fits) const {
    std::vector<Json> runs;
    std::copy_if(study_["runs"].begin(), study_["runs"].end(), std::back_inserter(runs), fits);
    return runs;
  }

  const Json& axis(const std::string& name) const {
    return *std::find_if(study_["axes"].begin(), study_["axes"].end(),
                         [&](const Json& one) { return one["name"] == name; });
  }

  /// The runs in the table of an axis, each once.
  std::set<std::string> rowsOf(const std::string& axisName) {
    std::set<std::string> ids;
    const Json rows = js(fmt::format(
        "[...document.querySelectorAll('[data-axis={}] tbody tr[data-run]')].map(row => row.dataset.run)", axisName));
    for (const Json& id : rows) EXPECT_TRUE(ids.insert(id).second) << id << " twice in " << axisName;
    return ids;
  }

  void expectSilence();
  void expectEveryRunAndTheFront();
  void expectEachAxisOnce();
  void expectFilesOfEachRun();

  TemporaryFolder folder_;
  Json study_;
  std::unique_ptr<Chromium> chromium_;
};

/// Nothing went wrong in the page, and it asked for itself and what it holds only.
void RealStudy::expectSilence() {
  EXPECT_FALSE(chromium_->requests().empty());
  for (const std::string& url : chromium_->requests())
    EXPECT_TRUE(url.starts_with("data:") || url == "file://" + page().string()) << url.substr(0, 200);
  for (const std::string& complaint : chromium_->complaints()) ADD_FAILURE() << complaint;
  EXPECT_EQ(js("document.title"), "Accuracy against time: cube.node");
  EXPECT_EQ(js("document.querySelector('#head').textContent.includes('not finished')"), false);
}

void RealStudy::expectEveryRunAndTheFront() {
  const auto measured = runsThat([](const Json& run) { return run["failed"].is_null(); });
  EXPECT_EQ(measured.size(), study_["runs"].size()) << "every run can be drawn";
  EXPECT_EQ(js("document.querySelectorAll('#front-plot .points path').length"), measured.size());
  auto front = runsThat([](const Json& run) { return run["on_front"] == true; });
  std::stable_sort(front.begin(), front.end(), [](const Json& a, const Json& b) {
    return a["frame_wall_ms"]["median"] < b["frame_wall_ms"]["median"];
  });
  Json ids = Json::array();
  for (const Json& run : front) ids.push_back(run["id"]);
  EXPECT_FALSE(ids.empty());
  EXPECT_EQ(js("[...document.querySelectorAll('#front-table tbody tr')].map(row => row.dataset.run)"), ids);
}

void RealStudy::expectEachAxisOnce() {
  EXPECT_EQ(rowsOf("k"), (std::set<std::string>{"cube-0/k=1", "cube-0/baseline"}));
  // Each lookup with its own table, none again with another one.
  EXPECT_EQ(rowsOf("lookup"),
            (std::set<std::string>{"cube-0/baseline", "cube-0/lookup=3d", "cube-0/lookup=2d", "cube-0/lookup=exact"}));
  // Every lookup that has a table at both sizes; that of the default at 64 is the baseline.
  EXPECT_EQ(rowsOf("table"), (std::set<std::string>{"cube-0/table=8", "cube-0/baseline", "cube-0/lookup=3d,table=8",
                                                    "cube-0/lookup=3d,table=64", "cube-0/lookup=2d,table=8",
                                                    "cube-0/lookup=2d,table=64"}));
  for (const char* name : {"k", "lookup", "table"})
    for (const std::string value : axis(name)["values"])
      EXPECT_EQ(js(fmt::format("[...document.querySelectorAll('[data-axis={}] tbody td:first-child button')]"
                               ".some(button => button.textContent === '{}')",
                               name, value)),
                true)
          << name << " " << value;
  EXPECT_EQ(axis("table")["baseline"], "64");
}

/// Chosen in the table of all runs.
void RealStudy::expectFilesOfEachRun() {
  for (const Json& run : study_["runs"]) {
    const std::string id = run["id"];
    js(
        fmt::format("document.querySelector('#all details').open = true;"
                    "document.querySelector('#all tr[data-run=\"{}\"] button').click()",
                    id));
    chromium_->waitFor(fmt::format("document.querySelector('#run')?.dataset.run === '{}'", id));
    EXPECT_NE(js("document.querySelector('#run').textContent").get<std::string>().find(run["label"]), std::string::npos)
        << id;
    for (const char* kind : {"image", "difference"}) {
      const std::string shown = fmt::format("document.querySelector('#run figure[data-kind={}] img')", kind);
      EXPECT_EQ(js(shown + ".decode().then(() => " + shown + ".naturalWidth > 0)"), true) << id << " " << kind;
      EXPECT_EQ(js(shown + ".src"),
                "data:image/png;base64," + base64(contentOf(folder_ / "out" / run[kind].get<std::string>())))
          << id << " " << kind;
    }
  }
}

TEST_F(RealStudy, IsShownByItsPage) {
  expectEveryRunAndTheFront();
  expectEachAxisOnce();
  expectFilesOfEachRun();
  expectSilence();
}

}  // namespace
}  // namespace havs::test
