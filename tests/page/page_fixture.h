#pragma once
// The made study's page in a browser, opened from disk and without a network.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "page/chromium.h"
#include "page/study_fixture.h"
#include "study/page.h"
#include "study/page_pictures.h"
#include "support/temporary_folder.h"

namespace havs::test {

using Json = nlohmann::json;

class PageTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!Chromium::isInstalled()) GTEST_SKIP() << "no Chromium to open the page with; Debian: apt install chromium";
    study_ = writeStudyFixture(folder_.path());
    chromium_ = std::make_unique<Chromium>();
  }

  void open(const Window& window = {}) {
    writeStudyPage(study_, folder_.path());
    chromium_->open(folder_ / "report.html", window);
  }

  /// The page asked for itself and what it holds, nothing else, and nothing went wrong in it.
  void TearDown() override {
    if (!chromium_) return;
    EXPECT_FALSE(chromium_->requests().empty()) << "the page's own opening was not seen";
    for (const std::string& url : chromium_->requests())
      EXPECT_TRUE(url.starts_with("data:") || url == "file://" + (folder_ / "report.html").string())
          << url.substr(0, 200);
    for (const std::string& complaint : chromium_->complaints()) EXPECT_TRUE(mayComplain_) << complaint;
  }

  Json js(const std::string& expression) { return chromium_->evaluate(expression); }

  std::vector<Json> measured(const std::string& subject) const {
    std::vector<Json> runs;
    for (const Json& run : study_["runs"])
      if (run["subject"] == subject && run["failed"].is_null()) runs.push_back(run);
    return runs;
  }

  const Json& run(const std::string& id) const {
    return *std::find_if(study_["runs"].begin(), study_["runs"].end(),
                         [&](const Json& one) { return one["id"] == id; });
  }

  /// Brings the front into view; returns when the page has heard of it.
  void scrollToFront() {
    js("new Promise(done => { document.querySelector('#front-plot').scrollIntoView({block: 'center'});"
       "requestAnimationFrame(() => requestAnimationFrame(() => done(true))); })");
  }

  /// Where the marks of the front's runs lie in the window, by the run's name.
  std::map<std::string, std::array<double, 2>> marks() {
    const Json list = js(R"([...document.querySelectorAll('#front-plot .points path')].map(path => {
      const box = path.getBoundingClientRect();
      return [path.__data__.datum.id, box.left + box.width / 2, box.top + box.height / 2];
    }))");
    std::map<std::string, std::array<double, 2>> places;
    for (const Json& one : list) places[one[0]] = {one[1], one[2]};
    return places;
  }

  /// The picture of a kind in the panel of the chosen run, as it must be: the file's bytes.
  void expectPicture(const std::string& kind, const std::string& file) {
    const std::string image = "document.querySelector('#run figure[data-kind=" + kind + "] img')";
    EXPECT_EQ(js(image + ".decode().then(() => " + image + ".naturalWidth)"), 40) << kind;
    EXPECT_EQ(js(image + ".src"), "data:image/png;base64," + base64(contentOf(folder_ / file))) << kind;
  }

  std::vector<std::string> shownFront() {
    return js("[...document.querySelectorAll('#front-table tbody tr')].map(row => row.dataset.run)")
        .get<std::vector<std::string>>();
  }

  TemporaryFolder folder_;
  Json study_;
  std::unique_ptr<Chromium> chromium_;
  bool mayComplain_ = false;
};

}  // namespace havs::test
