// The page of a study in a browser: opened from disk, without a network, and used as a reader uses it.
#include "study/page.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "page/page_fixture.h"

namespace havs {
namespace {

using Json = nlohmann::json;
using test::PageTest;
using test::Window;

/// What lies on the front by definition, fastest first.
std::vector<std::string> frontOf(const std::vector<Json>& runs, const std::string& measure, const std::string& time) {
  std::vector<std::pair<double, std::string>> front;
  for (const Json& run : runs) {
    const auto beats = [&](const Json& other) {
      const double t = other[time]["median"], u = run[time]["median"], e = other["error"][measure],
                   f = run["error"][measure];
      return other["settings"]["size"][0] == 512 && t <= u && e <= f && (t < u || e < f);
    };
    if (run["settings"]["size"][0] == 512 && std::none_of(runs.begin(), runs.end(), beats))
      front.emplace_back(run[time]["median"], run["id"]);
  }
  std::sort(front.begin(), front.end());
  std::vector<std::string> ids;
  for (const auto& [t, id] : front) ids.push_back(id);
  return ids;
}

/// All points lie on one line y = a + b x within `bound`.
void expectLine(const std::vector<std::array<double, 2>>& points, double bound, const char* what) {
  const auto [first, last] = std::minmax_element(points.begin(), points.end());
  const double slope = ((*last)[1] - (*first)[1]) / ((*last)[0] - (*first)[0]);
  EXPECT_GT(std::abs(slope), 1) << what;
  for (const auto& [x, y] : points) EXPECT_NEAR(y, (*first)[1] + slope * (x - (*first)[0]), bound) << what;
}

TEST_F(PageTest, FrontShowsEveryRunAtItsTimeAndError) {
  open();
  const auto runs = measured("bracket-0");
  const auto places = marks();
  ASSERT_EQ(places.size(), runs.size());
  std::vector<std::array<double, 2>> times, errors;
  double lowest = 0, exact = 0;
  for (const Json& one : runs) {
    const auto [x, y] = places.at(one["id"]);
    const double error = one["error"]["p999"];
    times.push_back({std::log10(one["frame_wall_ms"]["median"].get<double>()), x});
    if (error > 0) errors.push_back({std::log10(error), y});
    (error > 0 ? lowest : exact) = std::max(error > 0 ? lowest : exact, y);
  }
  expectLine(times, 0.6, "time");  // half a pixel: boxes of marks of different outlines
  expectLine(errors, 0.6, "error");
  EXPECT_GT(exact, lowest + 20) << "an exact 0 lies below all others";
  EXPECT_EQ(js("[...document.querySelectorAll('#front-plot text')].some(text => text.textContent === '0')"), true);
  EXPECT_NE(js("document.querySelector('#front-note').textContent")
                .get<std::string>()
                .find("1 run has an error of exactly 0"),
            std::string::npos);
}

TEST_F(PageTest, FrontIsWhatNoRunBeatsInEveryMeasure) {
  open();
  const auto runs = measured("bracket-0");
  EXPECT_EQ(shownFront(), frontOf(runs, "p999", "frame_wall_ms"));
  EXPECT_EQ(js("document.querySelectorAll('#front-plot .mark-line path').length"), 1);
  for (const char* measure : {"max", "rmse"})
    for (const char* time : {"frame_wall_ms", "frame_cpu_ms"}) {
      for (const char* value : {measure, time})
        js(fmt::format("document.querySelector('input[value={}]').click()", value));
      EXPECT_EQ(shownFront(), frontOf(runs, measure, time)) << measure << " " << time;
    }
}

TEST_F(PageTest, HoveredPointIsNamed) {
  open();
  scrollToFront();
  for (const auto& [id, place] : marks()) {
    const auto [x, y] = place;
    chromium_->movePointer(x, y);
    // Marks may cover each other: whichever is on top is named.
    const std::string top = js(fmt::format("document.elementFromPoint({}, {}).__data__?.datum?.id ?? ''", x, y));
    ASSERT_FALSE(top.empty()) << id;
    chromium_->waitFor("!document.querySelector('#tip').hidden");
    const std::string tip = js("document.querySelector('#tip').innerText");
    for (const std::string& part :
         {run(top)["label"].get<std::string>(), std::string("ms wall"), std::string("Misordered"),
          "sort " + run(top)["settings"]["sort"].get<std::string>()})
      EXPECT_NE(tip.find(part), std::string::npos) << part << " in " << tip;
    EXPECT_EQ(tip.find("the paper's choice") != std::string::npos, run(top)["kind"] == "paper");
    chromium_->movePointer(2, 2);
  }
}

TEST_F(PageTest, ChosenRunShowsItsPictures) {
  open();
  expectPicture("image", run("bracket-0/baseline")["image"]);  // shown from the beginning
  scrollToFront();
  const auto [x, y] = marks().at("bracket-0/paper");
  chromium_->click(x, y);
  chromium_->waitFor("document.querySelector('#run').dataset.run === 'bracket-0/paper'");
  expectPicture("image", run("bracket-0/paper")["image"]);
  expectPicture("difference", run("bracket-0/paper")["difference"]);
  expectPicture("reference", "images/bracket-0-reference.png");
  EXPECT_EQ(js("document.querySelectorAll('#front .chosen, #axes .chosen').length").get<int>(), 0)
      << "the paper's choice is in none of these tables";

  js("document.querySelector('[data-axis=k] tr[data-run=\"bracket-0/k=1\"] button').focus()");
  chromium_->pressKey("Enter");
  chromium_->waitFor("document.querySelector('[data-axis=k] #run')?.dataset.run === 'bracket-0/k=1'");
  expectPicture("image", run("bracket-0/k=1")["image"]);
  EXPECT_EQ(js("document.querySelectorAll('#run').length"), 1);
  EXPECT_EQ(js("document.querySelector('[data-axis=k] tr.chosen').dataset.run"), "bracket-0/k=1");
}

TEST_F(PageTest, ArrowKeysGoFromRunToRunInTheOrderOfTime) {
  open();
  auto runs = measured("bracket-0");
  std::stable_sort(runs.begin(), runs.end(), [](const Json& a, const Json& b) {
    return a["frame_wall_ms"]["median"] < b["frame_wall_ms"]["median"];
  });
  const auto at = std::find_if(runs.begin(), runs.end(), [](const Json& one) { return one["kind"] == "baseline"; });
  js("document.querySelector('#front-plot').focus()");
  chromium_->pressKey("ArrowRight");
  EXPECT_EQ(js("document.querySelector('#run').dataset.run"), (*(at + 1))["id"]);
  chromium_->pressKey("ArrowLeft");
  chromium_->pressKey("ArrowLeft");
  EXPECT_EQ(js("document.querySelector('#run').dataset.run"), (*(at - 1))["id"]);
}

TEST_F(PageTest, EachAxisHasItsTableAndOrderedOnesTheirPlots) {
  open();
  for (const Json& axis : study_["axes"]) {
    const std::string section = "document.querySelector('[data-axis=" + axis["name"].get<std::string>() + "]')";
    // Every value has a row, the default's too, which is measured once for all axes.
    const Json shown = js("[...new Set([..." + section +
                          ".querySelectorAll('tbody td:first-child button')].map(b => b.textContent))]");
    EXPECT_EQ(shown, axis["values"]) << axis["name"];
    EXPECT_EQ(js(section + ".querySelectorAll('svg').length"), axis["ordered"] == true ? 2 : 0) << axis["name"];
  }
  EXPECT_EQ(js("document.querySelectorAll('[data-axis=table] tbody tr').length"), 8) << "two lookups of four sizes";
  EXPECT_NE(js("document.querySelector('#failed').textContent")
                .get<std::string>()
                .find("this driver has 8; use k of at most 14"),
            std::string::npos);
  EXPECT_NE(js("document.querySelector('#failed').textContent").get<std::string>().find("2 GiB"), std::string::npos);
  EXPECT_EQ(js("document.querySelectorAll('#fits .mark-line path').length"), 2);
  EXPECT_NE(js("document.querySelector('#fits').textContent").get<std::string>().find("3d: slope −2.00"),
            std::string::npos);
}

TEST_F(PageTest, OtherSubjectReplacesEverything) {
  open();
  js("document.querySelector('input[value=fin-0]').click()");
  chromium_->waitFor("document.querySelector('#run').dataset.run === 'fin-0/baseline'");
  const auto runs = measured("fin-0");
  EXPECT_EQ(shownFront(), frontOf(runs, "p999", "frame_wall_ms"));
  chromium_->waitFor(fmt::format("document.querySelectorAll('#front-plot .points path').length === {}", runs.size()));
  for (const auto& [id, place] : marks()) EXPECT_TRUE(id.starts_with("fin-0/")) << id;
  expectPicture("reference", "images/fin-0-reference.png");
  EXPECT_EQ(
      js("[...document.querySelectorAll('tr[data-run]')].filter(row => !row.dataset.run.startsWith('fin-0/')).length"),
      0);
}

TEST_F(PageTest, AllRunsAreOrderedByTheHeadingPressed) {
  open();
  js("document.querySelector('#all details').open = true");
  const std::string press =
      "[...document.querySelectorAll('#all th button')].find(button => button.textContent === 'RMSE').click()";
  for (const bool down : {false, true}) {
    js(press);
    const auto ids = js("[...document.querySelectorAll('#all tbody tr')].map(row => row.dataset.run)")
                         .get<std::vector<std::string>>();
    ASSERT_EQ(ids.size(), measured("bracket-0").size() + 1);
    std::vector<double> errors;
    for (const std::string& id : ids)
      if (run(id)["failed"].is_null()) errors.push_back(run(id)["error"]["rmse"]);
    if (down) std::reverse(errors.begin(), errors.end());
    EXPECT_TRUE(std::is_sorted(errors.begin(), errors.end())) << down;
  }
}

TEST_F(PageTest, FitsAPhoneAndTheDark) {
  for (const Window& window : {Window{360, 740, true, false}, Window{1000, 700, false, true}}) {
    open(window);
    EXPECT_LE(js("document.documentElement.scrollWidth").get<int>(), window.width);
    EXPECT_EQ(
        js("[...document.querySelectorAll('.plot svg')].every(svg => svg.getBoundingClientRect().right <= innerWidth)"),
        true);
    EXPECT_EQ(js("getComputedStyle(document.body).backgroundColor"),
              window.dark ? "rgb(20, 23, 26)" : "rgb(255, 255, 255)");
  }
}

TEST_F(PageTest, PlotIsSavedWithItsColours) {
  open();
  js("globalThis.saved = []; HTMLAnchorElement.prototype.click = function () { saved.push([this.download, this.href]); "
     "}");
  js("document.querySelector('#save-svg').click(); document.querySelector('#save-png').click()");
  chromium_->waitFor("saved.length === 2");
  EXPECT_EQ(js("saved.map(([name]) => name)"), Json({"front-bracket-0-p999.svg", "front-bracket-0-p999.png"}));
  EXPECT_EQ(js("decodeURIComponent(saved[0][1]).includes('var(')"), false);
  EXPECT_EQ(
      js("new Promise(done => { const i = new Image; i.onload = () => done(i.width > 2000); i.src = saved[1][1]; })"),
      true);
}

TEST_F(PageTest, NothingLeavesThePageThatTries) {
  mayComplain_ = true;  // that is the point
  open();
  const Json stopped = js(R"(new Promise(done => {
    const stopped = [];
    document.addEventListener('securitypolicyviolation', event => { stopped.push(event.effectiveDirective); if (stopped.length === 2) done(stopped.sort()); });
    fetch('http://example.invalid/').catch(() => {});
    new Image().src = 'http://example.invalid/a.png';
  }))");
  EXPECT_EQ(stopped, Json({"connect-src", "img-src"}));
}

TEST_F(PageTest, TextsAreShownAsTheyAreAndGapsAreTold) {
  const std::string evil = "</script><img src=x onerror=\"document.title='evil'\"><!-- <script>";
  study_["command"] = evil;
  study_["complete"] = false;
  study_["runs"][0]["label"] = evil;
  study_["runs"][1]["image"] = "../study.json";
  study_["runs"][2]["error"]["p999"] = nullptr;
  study_["runs"][3] = {{"id", "bracket-0/k=2"},
                       {"subject", "bracket-0"},
                       {"kind", "axis"},
                       {"axis", "k"},
                       {"value", "2"},
                       {"label", "to come"},
                       {"settings", study_["runs"][3]["settings"]},
                       {"failed", nullptr}};
  open();
  EXPECT_EQ(js("document.querySelector('.command').textContent"), evil);
  EXPECT_NE(js("document.querySelector('#run h3').textContent").get<std::string>().find(evil), std::string::npos);
  EXPECT_EQ(js("document.title"), "Accuracy against time: bracket.vtu, fin.vtu");
  const std::string head = js("document.querySelector('#head').textContent");
  EXPECT_NE(head.find("not finished"), std::string::npos);
  EXPECT_NE(head.find("../study.json"), std::string::npos);
  EXPECT_NE(
      js("document.querySelector('#front-note').textContent").get<std::string>().find("1 run has no such measure"),
      std::string::npos);
  EXPECT_NE(js("document.querySelector('[data-axis=k]').textContent").get<std::string>().find("not measured yet"),
            std::string::npos);
}

TEST_F(PageTest, EmptyStudySaysSo) {
  study_["subjects"] = study_["runs"] = study_["axes"] = study_["fits"] = Json::array();
  open();
  EXPECT_NE(js("document.querySelector('main').textContent").get<std::string>().find("Nothing has been measured yet"),
            std::string::npos);
}

}  // namespace
}  // namespace havs
