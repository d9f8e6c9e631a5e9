// What effects cost, as the page of a study shows it.
#include "page/page_fixture.h"

namespace havs::test {
namespace {

class EffectsOnPage : public PageTest {
 protected:
  static constexpr const char* kRow = "document.querySelector('#effects tr[data-run=\"bracket-0/";
  /// The cells of a row, without what stands in small print.
  std::vector<std::string> cells(const std::string& run) {
    return js(std::string("[...") + kRow + run +
              "\"]').querySelectorAll('td')].map(cell => cell.firstChild.textContent)")
        .get<std::vector<std::string>>();
  }
  const Json& effect(const std::string& id) const {
    return *std::find_if(study_["effects"].begin(), study_["effects"].end(),
                         [&](const Json& one) { return one["id"] == id; });
  }
};

// "With" and "without" are told from what was added or left out; a ratio is that of the pairs.
TEST_F(EffectsOnPage, AreTheCostsOfEachBesideThePictureWithout) {
  open();
  const std::vector<std::string> added = cells("with lighting"), leftOut = cells("without clipping");
  ASSERT_EQ(added.size(), 9U);
  EXPECT_EQ(added[0], "with lighting");
  EXPECT_GT(std::stod(added[2]), std::stod(added[1])) << "slower with it";
  EXPECT_EQ(added[3], "2.50");
  EXPECT_EQ(added[4], "2.75");
  EXPECT_EQ(added[5], "40.0");
  EXPECT_EQ(added[6], "2 MiB");
  EXPECT_LT(std::stod(leftOut[2]), std::stod(leftOut[1])) << "faster with it";
  EXPECT_EQ(leftOut[3], "0.50");
  EXPECT_EQ(leftOut[5], "−40.0");
  EXPECT_EQ(leftOut[6], "−2 MiB");
  EXPECT_EQ(added[7], leftOut[8]) << "the error of the default, without the one and with the other";
  EXPECT_EQ(cells("with shadows")[1], "failed: no memory for <shadows>");
  EXPECT_NE(js("document.querySelector('#failed').textContent").get<std::string>().find("no memory for <shadows>"),
            std::string::npos);
}

TEST_F(EffectsOnPage, ShowTheirPicturesAndTheirLedger) {
  open();
  js(std::string(kRow) + "with lighting\"] button').click()");
  chromium_->waitFor("document.querySelector('#effects #run')?.dataset.run === 'bracket-0/with lighting'");
  const Json& lighting = effect("bracket-0/with lighting");
  for (const char* kind : {"image", "difference", "reference"}) expectPicture(kind, lighting[kind]);
  js("document.querySelector('#run .ledger').open = true");
  const Json rows =
      js("[...document.querySelectorAll('#run .ledger tbody tr')].map(row => "
         "[...row.cells].map(cell => cell.textContent))");
  EXPECT_EQ(rows, (Json{{"upload mesh", "1.25", "2 KiB", "place <and> scalar"}, {"draw", "40.5", "–", "draw"}}));
}

TEST_F(EffectsOnPage, AreNoRunsOfTheFront) {
  open();
  for (const std::string& id : shownFront()) EXPECT_EQ(id.find("with"), std::string::npos) << id;
  for (const auto& [id, place] : marks()) EXPECT_EQ(id.find("/with"), std::string::npos) << id;
}

TEST_F(EffectsOnPage, AreLeftOutWhereNoneWasMeasured) {
  study_.erase("effects");
  open();
  EXPECT_EQ(js("document.querySelector('#effects').children.length"), 0);
}

}  // namespace
}  // namespace havs::test
