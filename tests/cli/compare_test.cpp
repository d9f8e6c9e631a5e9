#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/run_havs.h"
#include "image/image.h"
#include "image/mask.h"

namespace havs::test {
namespace {

using testing::HasSubstr;

/// truth.exr: half transparent grey, 20 x 16, its left half empty; picture.exr: red off by 1/4 at 15,3, by 1/8 at 15,4.
class Compare : public testing::Test {
 protected:
  Compare() {
    Image image{20, 16, std::vector<float>(4 * 20 * 16)};
    for (int y = 0; y < 16; ++y)
      for (int x = 10; x < 20; ++x) std::fill_n(image.pixel(x, y), 4, 0.5f);
    writeImage(image, folder / "truth.exr");
    image.pixel(15, 3)[0] = 0.25f;
    image.pixel(15, 4)[0] = 0.375f;
    writeImage(image, folder / "picture.exr");
    writeImage(image, folder / "picture.png");
    std::vector<unsigned char> mask(20 * 16);
    mask[3 * 20 + 15] = 1;
    writeMask(mask, 20, 16, folder / "mask.png");
  }

  /// havs compare picture.exr truth.exr and these.
  Outcome compare(std::vector<std::string> options) {
    options.insert(options.begin(), {"compare", "picture.exr", "truth.exr"});
    return runHavs(options, folder.path());
  }
  nlohmann::json compareToJson(std::vector<std::string> options = {}) {
    options.push_back("--json");
    const Outcome run = compare(std::move(options));
    EXPECT_EQ(run.status, 0) << run.error;
    return nlohmann::json::parse(run.output);
  }

  TemporaryFolder folder;
};

TEST_F(Compare, JsonHoldsTheMeasures) {
  const auto json = compareToJson();
  const double square = (1.0 / 16 + 1.0 / 64) / 320;
  EXPECT_NEAR(json["channels"]["red"]["rmse"], std::sqrt(square), 1e-15);
  EXPECT_NEAR(json["rmse"], std::sqrt(square / 4), 1e-15);
  EXPECT_NEAR(json["psnr"], -10 * std::log10(square / 4), 1e-12);
  EXPECT_EQ(json["p999"], 0.25);
  EXPECT_EQ(json["max"], 0.25);
  EXPECT_LT(json["ssim"], 1);
  EXPECT_EQ(json["channels"]["opacity"]["ssim"], 1.0);
  EXPECT_EQ(json["channels"]["opacity"]["psnr"], nullptr);
  EXPECT_EQ(json["pixels"], 320);
  EXPECT_EQ(json["masked"], 0);
  EXPECT_EQ(json["worst"], (nlohmann::json{{"x", 15}, {"y", 3}, {"channel", "red"}}));
  EXPECT_EQ(json["content"], "rgba");
  EXPECT_FALSE(json.contains("with_masked_pixels"));
}

TEST_F(Compare, MaskGivesMeasuresWithoutAndWith) {
  const auto json = compareToJson({"--mask", "mask.png"});
  EXPECT_EQ(json["max"], 0.125);
  EXPECT_EQ(json["pixels"], 319);
  EXPECT_EQ(json["masked"], 1);
  EXPECT_EQ(json["with_masked_pixels"]["max"], 0.25);
  EXPECT_EQ(json["with_masked_pixels"]["pixels"], 320);
  EXPECT_EQ(json["with_masked_pixels"]["worst"]["y"], 3);
}

TEST_F(Compare, TextIsATable) {
  const std::string text = compare({"--mask", "mask.png"}).output;
  EXPECT_THAT(text, HasSubstr("319 compared, 1 masked"));
  EXPECT_THAT(text, HasSubstr("rgba"));
  EXPECT_THAT(text, HasSubstr("opacity"));
  EXPECT_THAT(text, HasSubstr("pixel 15,4 in red"));
  EXPECT_THAT(text, HasSubstr("with the masked pixels"));
}

TEST_F(Compare, DifferencePictureIsWritten) {
  const auto json = compareToJson({"--difference", "d.png", "--scale", "linear", "--max", "0.5"});
  EXPECT_EQ(json["difference"]["range"], (nlohmann::json{0.0, 0.5}));
  const Image difference = readImage(folder / "d.png");
  EXPECT_GT(difference.width, 20);
  float least = 1;
  for (int x = 0; x < 20; ++x) least = std::min(least, difference.pixel(x, 0)[0]);
  EXPECT_LT(least, 0.01f) << "no error is nearly black";
  EXPECT_GT(difference.pixel(15, 3)[0], 0.5f) << "half of the scale is red";
}

TEST_F(Compare, LimitsDecideTheStatus) {
  EXPECT_EQ(compare({"--limit", "max=0.25", "--limit", "ssim=0.5", "--limit", "psnr=20"}).status, 0);
  const Outcome beyond = compare({"--limit", "max=0.25", "--limit", "p999=0.2", "--quiet"});
  EXPECT_EQ(beyond.status, 1);
  EXPECT_EQ(beyond.error, "havs: picture.exr: p999 is 0.25, above the limit 0.2\n");
  EXPECT_EQ(beyond.output, "");
  EXPECT_THAT(compare({"--limit", "ssim=0.99999"}).error, HasSubstr("below the limit"));
  EXPECT_EQ(compare({"--mask", "mask.png", "--limit", "max=0.125"}).status, 0) << "masked pixels do not count";
}

TEST_F(Compare, EqualPicturesPassEveryLimit) {
  const Outcome run =
      runHavs({"compare", "truth.exr", "truth.exr", "--limit", "max=0", "--limit", "psnr=300"}, folder.path());
  EXPECT_EQ(run.status, 0) << run.error;
  EXPECT_THAT(run.output, HasSubstr("inf"));
}

TEST_F(Compare, EightBitsAreNoted) {
  const Outcome run = runHavs({"compare", "picture.png", "picture.png"}, folder.path());
  EXPECT_THAT(run.output, HasSubstr("8 bits a channel"));
  EXPECT_THAT(run.output, HasSubstr("\nrgb "));
  EXPECT_THAT(run.output, testing::Not(HasSubstr("opacity")));
}

TEST_F(Compare, QuietPrintsNothing) { EXPECT_EQ(compare({"--quiet"}).output, ""); }

}  // namespace
}  // namespace havs::test
