// What is written beside the page and into it, without a browser.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "image/image.h"
#include "page/study_fixture.h"
#include "study/front_points.h"
#include "study/page.h"
#include "study/page_pictures.h"
#include "study/page_shell.h"
#include "support/temporary_folder.h"

namespace havs {
namespace {

using Json = nlohmann::json;
using test::contentOf;
using test::TemporaryFolder;

TEST(Base64, MatchesRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(PageShell, HoldsOnePlaceForTheDataAndAsksForNothing) {
  const std::string shell(pageShell());
  const std::size_t place = shell.find(kPageData);
  ASSERT_NE(place, std::string::npos);
  EXPECT_EQ(shell.find(kPageData, place + 1), std::string::npos);
  EXPECT_EQ(shell.find("<!--HAVS:", place + 1), std::string::npos) << "a part was not put in";
  EXPECT_NE(shell.find("default-src 'none'"), std::string::npos);
  for (const char* asks : {"<script src", "<link", "@import", "<iframe", "sourceMappingURL"})
    EXPECT_EQ(shell.find(asks), std::string::npos) << asks;
  EXPECT_TRUE(shell.ends_with("</html>\n"));
}

Image checks(int width, int height) {
  Image image;
  image.width = width;
  image.height = height;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      // Columns in turn: opaque red, and nothing at all.
      const float on = x % 2 == 0 ? 1.0f : 0.0f;
      for (const float value : {on, 0.0f, 0.0f, on}) image.rgba.push_back(value);
    }
  return image;
}

TEST(ReducedPng, AveragesColourByOpacity) {
  const TemporaryFolder folder;
  writeImage(checks(6, 5), folder / "a.png", {.background = std::nullopt});
  writeImage(readImage(folder / "a.png"), folder / "b.png", {.background = std::nullopt});
  const Image half = readImage(folder.write("half.png", reducedPng(contentOf(folder / "a.png"), 2)));
  EXPECT_EQ(half.width, 3);
  EXPECT_EQ(half.height, 3);  // the last row is of one pixel each
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) {
      // Premultiplied: half of the block is opaque red, so (0.5, 0, 0, 0.5), rounded to 8 bits.
      const float* pixel = half.pixel(x, y);
      EXPECT_NEAR(pixel[0], 0.5, 1.0 / 255);
      EXPECT_EQ(pixel[1], 0);
      EXPECT_EQ(pixel[2], 0);
      EXPECT_NEAR(pixel[3], 0.5, 1.0 / 255);
    }
  EXPECT_EQ(reducedPng("no picture", 2), "no picture");
}

TEST(PagePictures, AreMadeSmallerUntilTheyFit) {
  const TemporaryFolder folder;
  const Json study = test::writeStudyFixture(folder.path());
  const PagePictures whole = readPagePictures(study, folder.path(), 1u << 30);
  EXPECT_EQ(whole.reduction, 1);
  EXPECT_EQ(whole.png.size(), 2 + 2 * 58) << "two references, and two pictures for each of 58 runs that did not fail";
  EXPECT_TRUE(whole.missing.empty());
  const StudyPage page = writeStudyPage(study, folder.path(), whole.bytes / 2);
  EXPECT_EQ(page.reduction, 2);
  EXPECT_EQ(page.pictures, whole.png.size());
  EXPECT_LT(page.pictureBytes, whole.bytes);
  EXPECT_NE(contentOf(folder / "report.html").find("data-reduced=\"2\""), std::string::npos);
}

TEST(PagePictures, OnlyPngInsideTheFolderIsTaken) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "study");
  writeImage(checks(2, 2), folder / "outside.png");
  folder.write("study/secret.txt", "not a picture");
  const std::string outside = (folder / "outside.png").string();
  Json runs = Json::array();
  for (const std::string& name :
       {std::string("../outside.png"), outside, std::string("secret.txt"), std::string("none.png")})
    runs.push_back({{"image", name}});
  const PagePictures pictures = readPagePictures({{"runs", runs}}, folder / "study", 1u << 20);
  EXPECT_TRUE(pictures.png.empty());
  EXPECT_THAT(pictures.missing, testing::UnorderedElementsAre("../outside.png", outside, "secret.txt", "none.png"));
}

TEST(StudyPage, IsWrittenFromTheFolderAloneAndTheSame) {
  const TemporaryFolder folder;
  const Json study = test::writeStudyFixture(folder.path());
  writeStudyPage(study, folder.path());
  const std::string first = contentOf(folder / "report.html");
  EXPECT_EQ(rewriteStudyPage(folder.path()).bytes, first.size());
  EXPECT_EQ(contentOf(folder / "report.html"), first);
}

TEST(StudyPage, RefusesWhatIsNoStudy) {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& content) {
    if (!content.empty()) folder.write("study.json", content);
    try {
      rewriteStudyPage(folder.path());
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input) << content;
      EXPECT_FALSE(std::filesystem::exists(folder / "report.html")) << content;
      return std::string(error.what());
    }
    return std::string("it was taken");
  };
  EXPECT_THAT(refused(""), testing::HasSubstr("no study.json there"));
  EXPECT_THAT(refused("{\"version\": 1, "), testing::HasSubstr("broken JSON"));
  EXPECT_THAT(refused("[]"), testing::HasSubstr("no study of version 1"));
  EXPECT_THAT(refused("{\"version\": 2}"), testing::HasSubstr("no study of version 1"));
  EXPECT_THAT(refused("{\"version\": 1, \"subjects\": [], \"axes\": []}"), testing::HasSubstr("no list 'runs'"));
  EXPECT_THAT(refused("{\"version\": 1, \"subjects\": [], \"axes\": [], \"runs\": {}}"),
              testing::HasSubstr("no list 'runs'"));
}

TEST(FrontFigure, IsAnSvgAndAPngOfAllSubjects) {
  const TemporaryFolder folder;
  const Json study = test::writeStudyFixture(folder.path());
  writeStudyPage(study, folder.path());
  const std::string svg = contentOf(folder / "front.svg");
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
  const Image png = readImage(folder / "front.png");
  EXPECT_EQ(png.width, 1520);
  // Two panels, and a line for each run on a front (front_figure.cpp).
  std::size_t lines = 0;
  for (const FrontPanel& panel : frontPanels(study))
    for (const FrontPoint& point : panel.points) lines += point.onFront;
  EXPECT_EQ(png.height, 2 * static_cast<int>(2 * (62 + 380 + 56 + 2 * 17) + 17 * lines));
  EXPECT_EQ(frontPanels(study).size(), 2u);
}

TEST(FrontPanels, LeaveOutWhatFailedAndOtherSizes) {
  const TemporaryFolder folder;
  const Json study = test::writeStudyFixture(folder.path());
  std::size_t comparable = 0;
  for (const Json& run : study["runs"])
    comparable += run["subject"] == "fin-0" && run["failed"].is_null() && run["settings"]["size"][0] == 512;
  const FrontPanel panel = frontPanels(study)[1];
  EXPECT_EQ(panel.title, "fin.vtu, density, three-peaks");
  EXPECT_EQ(panel.points.size(), comparable);
  EXPECT_TRUE(panel.points.back().onFront);
  EXPECT_FALSE(panel.points.front().onFront);
}

TEST(LogAxis, PutsExactZeroBelowAllOthers) {
  const LogAxis axis = logAxis({1e-5, 0, 3e-2});
  EXPECT_EQ(axis.ticks.front(), 0);
  EXPECT_LT(axis.at(0), axis.at(1e-5));
  EXPECT_GE(axis.at(0), 0);
  EXPECT_LE(axis.at(3e-2), 1);
  // Equal factors are equal distances.
  EXPECT_NEAR(axis.at(1e-3) - axis.at(1e-4), axis.at(1e-2) - axis.at(1e-3), 1e-12);
  for (std::size_t i = 1; i < axis.ticks.size(); ++i) EXPECT_GE(axis.ticks[i], axis.zero);
}

TEST(LogAxis, HasAFewTicksInsideItsRangeForAnySpan) {
  for (const double span : {1.0, 1.5, 4.0, 30.0, 1e3, 1e6, 1e14}) {
    const LogAxis axis = logAxis({0.02, 0.02 * span});
    EXPECT_GE(axis.ticks.size(), span < 2 ? 1u : 2u) << span;
    EXPECT_LE(axis.ticks.size(), 9u) << span;
    for (const double tick : axis.ticks) {
      EXPECT_GE(tick, axis.least) << span;
      EXPECT_LE(tick, axis.most) << span;
    }
  }
}

TEST(LogAxis, TicksAreWrittenShort) {
  EXPECT_EQ(tickText(0), "0");
  EXPECT_EQ(tickText(1e-4), "1e-4");
  EXPECT_EQ(tickText(5e-7), "5e-7");
  EXPECT_EQ(tickText(0.2), "0.2");
  EXPECT_EQ(tickText(2000), "2000");
  EXPECT_EQ(tickText(3e6), "3e6");
}

}  // namespace
}  // namespace havs
