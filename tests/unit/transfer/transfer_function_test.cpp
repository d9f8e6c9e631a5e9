// Evaluation, presets and our own file format.
#include "transfer/transfer_function.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "transfer/extinction_curve.h"
#include "unit/transfer/temporary_file.h"

namespace havs {
namespace {

void expectSame(const TransferFunction& a, const TransferFunction& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.normalised, b.normalised);
  EXPECT_EQ(a.meaning, b.meaning);
  EXPECT_EQ(a.unitLength, b.unitLength);
  EXPECT_EQ(a.domain, b.domain);
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    EXPECT_EQ(a.points[i].scalar, b.points[i].scalar);
    EXPECT_EQ(a.points[i].color, b.points[i].color);
    EXPECT_EQ(a.points[i].opacity, b.points[i].opacity);
  }
}

TEST(TransferFunction, IsLinearBetweenPointsAndConstantBeyond) {
  const TransferFunction f{.points = {{2, {0, 0, 1}, 0.25}, {4, {1, 0, 0}, 0.75}}};
  EXPECT_EQ(evaluate(f, 1).opacity, 0.25);
  EXPECT_EQ(evaluate(f, 5).color[0], 1);
  EXPECT_DOUBLE_EQ(evaluate(f, 2.5).opacity, 0.375);
  EXPECT_DOUBLE_EQ(evaluate(f, 2.5).color[2], 0.75);
  EXPECT_EQ(evaluate(f, 2.5).scalar, 2.5);
}

TEST(TransferFunction, StepTakesTheUpperSide) {
  const TransferFunction f{.points = {{0, {}, 0.1}, {0.5, {}, 0.1}, {0.5, {}, 0.9}, {1, {}, 0.9}}};
  EXPECT_EQ(evaluate(f, 0.5).opacity, 0.9);
  EXPECT_DOUBLE_EQ(evaluate(f, std::nextafter(0.5, 0)).opacity, 0.1);
}

TEST(TransferFunction, JsonRoundTripIsBitForBit) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  TransferFunction f{.name = "näme \"quoted\"", .normalised = false, .meaning = OpacityMeaning::extinction};
  f.unitLength = 0.1 / 3;
  f.domain = {-1e300 / 7, 1e-300 / 3};
  double scalar = -5;
  for (int i = 0; i < 500; ++i) {
    scalar += unit(random) * 1e-3;
    f.points.push_back({scalar, {unit(random), unit(random), unit(random)}, unit(random) * 1e5});
  }
  const test::TemporaryFile file("f.json", toJson(f));
  expectSame(loadTransferFunction(file.path()), f);
}

TEST(TransferFunction, DefaultsOfTheFile) {
  const test::TemporaryFile file("plain.json",
                                 R"({"version": 1, "points": [{"scalar": 0, "color": [1, 0, 0], "opacity": 0.5}]})");
  const TransferFunction f = loadTransferFunction(file.path());
  EXPECT_EQ(f.name, "plain");
  EXPECT_TRUE(f.normalised);
  EXPECT_EQ(f.meaning, OpacityMeaning::perUnit);
  EXPECT_FALSE(f.unitLength || f.domain);
}

TEST(TransferPresets, LoadByNameMakeCurvesAndSurviveTheFile) {
  ASSERT_GE(transferPresets().size(), 8u);
  for (const TransferPreset& preset : transferPresets()) {
    SCOPED_TRACE(preset.name);
    const TransferFunction f = loadTransferFunction(preset.name);
    EXPECT_EQ(f.name, preset.name);
    EXPECT_FALSE(preset.description.empty());
    const ExtinctionCurve curve = makeCurve(f, {});
    EXPECT_GT(curve.maximumKappa, 0);
    EXPECT_EQ(curve.opaque.empty(), preset.name != "plateau-opaque");
    const test::TemporaryFile file("preset.json", toJson(f));
    expectSame(loadTransferFunction(file.path()), f);
  }
}

TEST(TransferPresets, TheExerciseOfTheCourse) {
  const TransferFunction f = loadTransferFunction("plateau-opaque");
  EXPECT_THAT(evaluate(f, 64 / 255.0).color, testing::ElementsAre(1.0, 0.384313, 0.384313));
  EXPECT_EQ(evaluate(f, 64 / 255.0).opacity, 0);
  EXPECT_DOUBLE_EQ(evaluate(f, 96 / 255.0).opacity, 0.5);
  EXPECT_EQ(evaluate(f, 160 / 255.0).opacity, 1);
  EXPECT_EQ(evaluate(f, 0).opacity, 0);
  EXPECT_EQ(evaluate(f, 1).opacity, 0);
}

}  // namespace
}  // namespace havs
