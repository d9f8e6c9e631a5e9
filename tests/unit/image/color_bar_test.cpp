#include "image/color_bar.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "image/canvas.h"

namespace havs {
namespace {

ColorBar redToBlue() { return {.scale = {{0, 1}, {{1, 0, 0}, {0, 0, 1}}}, .title = "error"}; }

/// Opaque pixels darker than half in a part of a picture: text and lines in black.
int inkIn(const Image& image, int left, int right, int top, int bottom) {
  int count = 0;
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) count += image.pixel(x, y)[3] > 0.5f ? 1 : 0;
  return count;
}

TEST(ColorScale, GoesLinearlyFromColourToColour) {
  const ColorScale scale{{0, 4}, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}};
  EXPECT_EQ(scale.at(-1), (Color{0, 0, 0}));
  EXPECT_EQ(scale.at(1), (Color{0.5, 0, 0}));
  EXPECT_EQ(scale.at(2), (Color{1, 0, 0}));
  EXPECT_EQ(scale.at(3), (Color{1, 0.5, 0}));
  EXPECT_EQ(scale.at(9), (Color{1, 1, 0}));
}

TEST(ColorBarPicture, EachRowHasItsColour) {
  const ColorBar bar = redToBlue();
  const Image image = drawColorBar(bar, 200);
  const RowRange rows = colorBarRows(bar, 200), columns = colorBarColumns(bar);
  const int count = rows.last - rows.first + 1;
  for (int y = rows.first; y <= rows.last; ++y) {
    const auto red = static_cast<float>((y - rows.first + 0.5) / count);
    for (int x = columns.first; x <= columns.last; ++x) {
      EXPECT_NEAR(image.pixel(x, y)[0], red, 1e-6) << y;
      EXPECT_NEAR(image.pixel(x, y)[2], 1 - red, 1e-6) << y;
      EXPECT_EQ(image.pixel(x, y)[3], 1);
    }
  }
}

TEST(ColorBarPicture, HasTicksWhereTheAxisSays) {
  const ColorBar bar = redToBlue();
  const Image image = drawColorBar(bar, 200);
  const RowRange rows = colorBarRows(bar, 200);
  const int right = colorBarColumns(bar).last + 2;
  const int count = rows.last - rows.first + 1;
  for (int y = rows.first - 1; y <= rows.last + 1; ++y) {
    double nearest = 1e9;
    for (const Tick& tick : ticksOf(bar.scale.axis, 6))
      nearest = std::min(nearest, std::abs(rows.last + 1 - tick.position * count - (y + 0.5)));
    const bool marked = image.pixel(right, y)[3] > 0;
    if (nearest > 0.5 && nearest < 1) continue;  // touched by a smoothed line
    EXPECT_EQ(marked, nearest <= 0.5) << y;
  }
}

TEST(ColorBarPicture, TextStandsInsideThePicture) {
  for (const char* title :
       {"", "error of the worst channel, logarithmic", "a title that is far longer than the bar is high"}) {
    ColorBar bar = redToBlue();
    bar.title = title;
    bar.scale.axis = {1e-7, 0.3, true};
    const Image image = drawColorBar(bar, 120);
    EXPECT_EQ(image.width, colorBarWidth(bar));
    EXPECT_EQ(image.height, 120);
    EXPECT_EQ(inkIn(image, image.width - 1, image.width - 1, 0, 119), 0) << title;
    EXPECT_EQ(inkIn(image, colorBarColumns(bar).last + 1, image.width - 1, 0, 0), 0) << title;
    EXPECT_EQ(inkIn(image, colorBarColumns(bar).last + 1, image.width - 1, 119, 119), 0) << title;
    EXPECT_GT(inkIn(image, colorBarColumns(bar).last + 1, image.width - 1, 0, 119), 50) << title;
  }
}

TEST(ColorBarPicture, PointsWhereValuesLieBeyond) {
  ColorBar bar = redToBlue();
  const int middle = (colorBarColumns(bar).first + colorBarColumns(bar).last) / 2;
  const auto blueAboveTheBar = [&] {
    return drawColorBar(bar, 100).pixel(middle, colorBarRows(bar, 100).first - 1)[2];
  };
  EXPECT_EQ(blueAboveTheBar(), 0);
  bar.beyondHigh = true;
  EXPECT_NEAR(blueAboveTheBar(), 1, 0.01);
}

TEST(ColorBarPicture, RefusesWhatCannotBeDrawn) {
  EXPECT_THROW(drawColorBar(redToBlue(), 39), Error);
  ColorBar bar = redToBlue();
  bar.scale.colors.clear();
  EXPECT_THROW(drawColorBar(bar, 100), Error);
  bar = redToBlue();
  bar.scale.axis = {1, 0};
  EXPECT_THROW(drawColorBar(bar, 100), Error);
}

TEST(Canvas, LayTakesOpaquePixelsBitForBit) {
  Image onto = plainImage(3, 3, {1, 1, 1});
  const Image what{2, 1, {0.1234567f, 0, -2, 1, 0.25f, 0, 0, 0.5f}};
  lay(what, 1, 1, onto);
  EXPECT_EQ(onto.pixel(1, 1)[0], 0.1234567f);
  EXPECT_EQ(onto.pixel(1, 1)[2], -2);
  EXPECT_EQ(onto.pixel(2, 1)[0], 0.75f);
  EXPECT_EQ(onto.pixel(2, 1)[3], 1);
  lay(what, -1, 2, onto);  // the left half falls outside
  EXPECT_EQ(onto.pixel(0, 2)[0], 0.75f);
  lay(what, 7, -5, onto);
}

TEST(Canvas, RefusesSizesThatCairoCannot) {
  EXPECT_THROW(Canvas(0, 5), Error);
  EXPECT_THROW(Canvas(5, 40000), Error);
}

}  // namespace
}  // namespace havs
