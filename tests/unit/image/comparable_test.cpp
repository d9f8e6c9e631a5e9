#include "image/comparable.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "unit/image/pictures.h"

namespace havs {
namespace {

using test::madeImage;
using testing::HasSubstr;

/// A square of the given opacity in its middle, empty around it; colour is half the opacity.
NamedPicture clearPicture(const std::string& name, double opacity = 0.5) {
  return {name, {madeImage(8, 8, [=](int x, int y, int c) {
            const bool inside = x > 1 && x < 6 && y > 1 && y < 6;
            return inside ? (c == 3 ? opacity : opacity / 2) : 0.0;
          })}};
}

/// The same over a grey background.
NamedPicture overBackground(const std::string& name, double background, ImageContent content = ImageContent::rgb) {
  NamedPicture picture = clearPicture(name);
  Image& image = picture.stored.image;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c) image.rgba[i + c] += (1 - image.rgba[i + 3]) * static_cast<float>(background);
    image.rgba[i + 3] = 1;
  }
  picture.stored.content = content;
  return picture;
}

std::string refusal(const NamedPicture& a, const NamedPicture& b) {
  try {
    commonContent(a, b);
  } catch (const Error& error) {
    EXPECT_EQ(error.exitStatus(), 2);
    return error.what();
  }
  return "nothing was thrown";
}

TEST(CommonContent, OfTwoWithOpacityIsRgba) {
  EXPECT_EQ(commonContent(clearPicture("a"), clearPicture("b", 0.75)), ImageContent::rgba);
}

TEST(CommonContent, OfTwoOverABackgroundIsRgb) {
  EXPECT_EQ(commonContent(overBackground("a", 1), overBackground("b", 1)), ImageContent::rgb);
}

/// Another program's PNG may hold an opacity that is 1 everywhere.
TEST(CommonContent, OpaqueEverywhereIsLikeOverABackground) {
  EXPECT_EQ(commonContent(overBackground("a", 1, ImageContent::rgba), overBackground("b", 1)), ImageContent::rgb);
  EXPECT_EQ(commonContent(overBackground("a", 1, ImageContent::rgba), overBackground("b", 1, ImageContent::rgba)),
            ImageContent::rgba);
}

TEST(CommonContent, RefusesOpacityAgainstABackground) {
  EXPECT_THAT(refusal(overBackground("a.pfm", 1), clearPicture("b.exr")), HasSubstr("a.pfm: holds colours over"));
  EXPECT_THAT(refusal(clearPicture("a.exr"), overBackground("b.pfm", 1)), HasSubstr("b.pfm: holds colours over"));
  EXPECT_THAT(refusal(overBackground("a.exr", 1, ImageContent::rgba), clearPicture("b.exr")),
              HasSubstr("a.exr: is opaque in every pixel"));
}

/// A full picture of an opaque thing against one that is nearly so is no matter of backgrounds.
TEST(CommonContent, NearlyOpaqueIsTaken) {
  const NamedPicture full{"a", {test::constantImage(4, 4, 1)}}, nearly{"b", {test::constantImage(4, 4, 0.99)}};
  EXPECT_EQ(commonContent(full, nearly), ImageContent::rgba);
}

TEST(ComparisonNotes, SayWhatFilesRounded) {
  NamedPicture png = overBackground("a.png", 1);
  png.stored.bits = 8;
  png.stored.floats = false;
  NamedPicture half = overBackground("b.exr", 1);
  half.stored.bits = 16;
  EXPECT_THAT(comparisonNotes(png, half),
              testing::ElementsAre(HasSubstr("a.png has 8 bits"), HasSubstr("b.exr has 16-bit")));
  EXPECT_THAT(comparisonNotes(overBackground("a", 1), overBackground("b", 1)), testing::IsEmpty());
}

TEST(ComparisonNotes, AskWhetherBackgroundsDiffer) {
  EXPECT_THAT(comparisonNotes(overBackground("a", 1), overBackground("b", 0)),
              testing::ElementsAre(HasSubstr("the border of a is 1,1,1, that of b is 0,0,0")));
  EXPECT_THAT(comparisonNotes(clearPicture("a"), clearPicture("b")), testing::IsEmpty());
}

}  // namespace
}  // namespace havs
