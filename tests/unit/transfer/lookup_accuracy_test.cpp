// What the lookups with tables are worth on the built-in transfer functions, against integrateSegment.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "unit/transfer/lookup_functions.h"

namespace havs::test {
namespace {

struct Errors {
  double rootMeanSquare = 0, high = 0, maximum = 0;  // high: what one segment in a thousand exceeds
};

Errors errorsOf(const ExtinctionCurve& curve, const LookupFunction& lookup, double longest, double widest) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> errors;
  double squares = 0;
  for (int i = 0; i < 10000; ++i) {
    const double front = unit(random), length = longest * unit(random);
    const double back = std::clamp(front + widest * (2 * unit(random) - 1), 0.0, 1.0);
    errors.push_back(distance(lookup(front, back, length), exactly(curve, front, back, length)));
    squares += errors.back() * errors.back();
  }
  std::sort(errors.begin(), errors.end());
  return {std::sqrt(squares / static_cast<double>(errors.size())), errors[errors.size() * 999 / 1000], errors.back()};
}

// 64^3 against 128^3 come out alike (docs/02-method.md); half as large they take an eighth of the time.
TEST(LookupAccuracy, MeanColoursAgainstColoursInATableOfTwiceTheSize) {
  constexpr int kSize = 24;
  constexpr double kLongest = 0.1;
  for (const TransferPreset& preset : transferPresets()) {
    const ExtinctionCurve curve = withoutOpaque(makeCurve(preset.function, {}));
    const LookupFunction means = normalisedLookup(curve, kSize, kLongest);
    const LookupFunction colors = table3dLookup(curve, 2 * kSize, kLongest);
    for (double widest : {1.0, 0.05}) {
      const Errors mean = errorsOf(curve, means, kLongest, widest), color = errorsOf(curve, colors, kLongest, widest);
      RecordProperty(fmt::format("{}_{}", preset.name, widest),
                     fmt::format("{:.2g} {:.2g} {:.2g} against {:.2g} {:.2g} {:.2g}", mean.rootMeanSquare, mean.high,
                                 mean.maximum, color.rootMeanSquare, color.high, color.maximum));
      EXPECT_LE(mean.rootMeanSquare, color.rootMeanSquare) << preset.name << ", spans to " << widest;
    }
  }
}

}  // namespace
}  // namespace havs::test
