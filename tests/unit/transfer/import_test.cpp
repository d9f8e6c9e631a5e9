// ParaView's colour maps, colour spaces, TF.bin.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "transfer/color_space.h"
#include "transfer/transfer_function.h"
#include "unit/transfer/temporary_file.h"

namespace havs {
namespace {

TransferFunction load(const std::string& name, const std::string& content) {
  const test::TemporaryFile file(name, content);
  return loadTransferFunction(file.path());
}

TEST(ParaView, JsonMergesColoursAndOpacities) {
  const TransferFunction f = load("map.json", R"([{"ColorSpace": "RGB", "Name": "mine", "NanColor": [1, 1, 0],
      "RGBPoints": [100, 0, 0, 1,  200, 0, 1, 0,  300, 1, 0, 0], "Points": [100, 0, 0.5, 0,  250, 0.6, 0.5, 0,  300, 2.5, 0.5, 0]}])");
  EXPECT_EQ(f.name, "mine");
  EXPECT_EQ(f.meaning, OpacityMeaning::extinction);
  EXPECT_TRUE(f.normalised);
  ASSERT_EQ(f.points.size(), 4u);
  EXPECT_DOUBLE_EQ(f.points[1].scalar, 0.5);
  EXPECT_DOUBLE_EQ(f.points[1].opacity, 0.4);  // of the opacities' line at a knot of the colours
  EXPECT_DOUBLE_EQ(f.points[2].color[1], 0.5);
  EXPECT_DOUBLE_EQ(f.points[3].opacity, 2.5);
}

TEST(ParaView, MapWithoutOpacitiesGetsARamp) {
  const std::string colors = R"("RGBPoints": [-1, 0, 0, 1,  1, 1, 0, 0]})";
  for (const std::string& text :
       {"[{" + colors + "]", "{" + colors,
        std::string(R"(<ColorMaps><ColorMap name="m" space="RGB"><Point x="-1" o="1" r="0" g="0" b="1"/>
                                                 <Point x="1" o="1" r="1" g="0" b="0"/><NaN r="1" g="0" b="0"/></ColorMap></ColorMaps>)")}) {
    const TransferFunction f = load("map", text);
    ASSERT_EQ(f.points.size(), 2u);
    EXPECT_EQ(f.points[0].opacity, 0);
    EXPECT_EQ(f.points[1].opacity, 1);
    EXPECT_EQ(f.points[0].color[2], 1);
  }
}

TEST(ParaView, XmlKeepsItsOpacities) {
  const TransferFunction f =
      load("map.xml", R"(<?xml version="1.0"?><ColorMap space="RGB"><Point x="5" o="0.5" r="0" g="0" b="1"/>
                                                <Point x="3" o="0.25" r="1" g="0" b="0"/></ColorMap>)");
  EXPECT_EQ(f.name, "map");
  ASSERT_EQ(f.points.size(), 2u);
  EXPECT_EQ(f.points[0].opacity, 0.25);  // sorted, as ParaView does
  EXPECT_EQ(f.points[1].color[2], 1);
}

TEST(ParaView, SharpnessOneIsAStepAtTheMidpoint) {
  const TransferFunction f =
      load("map.json", R"({"RGBPoints": [0, 0, 0, 0, 1, 1, 1, 1], "Points": [0, 0.2, 0.25, 1, 1, 0.8, 0.5, 0]})");
  EXPECT_DOUBLE_EQ(evaluate(f, 0.2499).opacity, 0.2);
  EXPECT_DOUBLE_EQ(evaluate(f, 0.25).opacity, 0.8);
  EXPECT_DOUBLE_EQ(evaluate(f, 0.25).color[0], 0.25);
}

TEST(ParaView, MidpointAndSharpnessBendTheOpacity) {
  const TransferFunction f =
      load("map.json", R"({"RGBPoints": [0, 0, 0, 0, 1, 1, 1, 1], "Points": [0, 0, 0.3, 0.5, 1, 1, 0.5, 0]})");
  EXPECT_NEAR(evaluate(f, 0.3).opacity, 0.5, 0.02);  // half way at the midpoint, within the 64 linear pieces
  EXPECT_LT(evaluate(f, 0.1).opacity, 0.01);         // flatter than linear at the ends
  EXPECT_GT(evaluate(f, 0.8).opacity, 0.99);
}

TEST(ParaView, StepSpaceTakesTheSecondColour) {
  const TransferFunction f =
      load("map.json", R"({"ColorSpace": "Step", "RGBPoints": [0, 1, 0, 0, 0.5, 0, 1, 0, 1, 0, 0, 1]})");
  EXPECT_EQ(evaluate(f, 0.25).color[1], 1);
  EXPECT_EQ(evaluate(f, 0.75).color[2], 1);
}

TEST(ColorSpaces, EndsAreKept) {
  const RgbColor a{0.2, 0.7, 0.4}, b{0.9, 0.1, 0.3};
  for (ColorSpace space :
       {ColorSpace::rgb, ColorSpace::hsv, ColorSpace::hsvNoWrap, ColorSpace::lab, ColorSpace::diverging}) {
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(interpolateColor(space, a, b, 0)[c], a[c], 1e-3);  // the matrices of sRGB have four digits
      EXPECT_NEAR(interpolateColor(space, a, b, 1)[c], b[c], 1e-3);
    }
  }
}

TEST(ColorSpaces, HsvGoesTheShorterWayRound) {
  const RgbColor red{1, 0, 0}, magenta{1, 0, 1};  // hues 0 and 5/6
  const RgbColor wrapped = interpolateColor(ColorSpace::hsv, red, magenta, 0.5);
  EXPECT_NEAR(wrapped[0], 1, 1e-12);
  EXPECT_NEAR(wrapped[2], 0.5, 1e-12);
  const RgbColor direct = interpolateColor(ColorSpace::hsvNoWrap, red, magenta, 0.4);  // hue 1/3
  EXPECT_NEAR(direct[1], 1, 1e-12);
  EXPECT_NEAR(direct[0], 0, 1e-12);
}

TEST(ColorSpaces, LabOfGraysIsGray) {
  const RgbColor middle = interpolateColor(ColorSpace::lab, {0, 0, 0}, {1, 1, 1}, 0.5);  // L = 50 is sRGB 0.466
  for (double c : middle) EXPECT_NEAR(c, 0.466, 2e-3);
}

TEST(ColorSpaces, CoolWarmIsMorelandsTable) {
  // Moreland 2009, table of the cool to warm map in 8 bits: quarter points.
  const RgbColor blue{59 / 255.0, 76 / 255.0, 192 / 255.0}, red{180 / 255.0, 4 / 255.0, 38 / 255.0};
  const std::vector<std::pair<double, RgbColor>> table{
      {0.25, {141, 176, 254}}, {0.5, {221, 221, 221}}, {0.75, {244, 154, 123}}};
  for (const auto& [t, rgb] : table) {
    const RgbColor color = interpolateColor(ColorSpace::diverging, blue, red, t);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(color[c] * 255, rgb[c], 1.5) << t;
  }
}

TEST(ColorSpaces, ResamplingFollowsTheCurve) {
  const std::vector<ControlPoint> ends{{0, {0.230, 0.299, 0.754}, 0}, {1, {0.706, 0.016, 0.150}, 0}};
  const TransferFunction f{.points = resampleToRgb(ColorSpace::diverging, ends)};
  EXPECT_LT(f.points.size(), 200u);
  for (int i = 0; i <= 1000; ++i) {
    const RgbColor exact = interpolateColor(ColorSpace::diverging, ends[0].color, ends[1].color, i / 1000.0);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(evaluate(f, i / 1000.0).color[c], exact[c], 2.0 / 1024);
  }
}

std::vector<float> sampled(const TransferFunction& f) {
  std::vector<float> values;
  for (int i = 0; i < 65536; ++i) {
    const ControlPoint p = evaluate(f, i / 65535.0);
    for (double c : {p.color[0], p.color[1], p.color[2], p.opacity}) values.push_back(static_cast<float>(c));
  }
  return values;
}

std::string bytesOf(const std::vector<float>& values) {
  std::string bytes(values.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

TEST(TableFile, CollinearEntriesAreLeftOutWithin1e6) {
  const std::vector<float> values = sampled(loadTransferFunction("viridis"));
  const TransferFunction f = load("TF.bin", bytesOf(values));
  EXPECT_EQ(f.name, "TF");
  EXPECT_EQ(f.meaning, OpacityMeaning::perUnit);
  EXPECT_LT(f.points.size(), 60u);  // 10 control points, none of them on an entry
  for (int i = 0; i < 65536; ++i) {
    const ControlPoint p = evaluate(f, i / 65535.0);
    ASSERT_NEAR(p.opacity, values[4 * i + 3], 1.001e-6) << i;
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(p.color[c], values[4 * i + c], 1.001e-6) << i;
  }
}

TEST(TableFile, NoiseIsKeptEntryByEntry) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<float> values(65536 * 4);
  for (float& v : values) v = unit(random);
  const TransferFunction f = load("TF.bin", bytesOf(values));
  ASSERT_EQ(f.points.size(), 65536u);
  EXPECT_EQ(f.points[12345].opacity, values[4 * 12345 + 3]);
}

}  // namespace
}  // namespace havs
