// The lookups without tables of colours, by the shaders' own arithmetic over a packed curve, against integrateSegment.
#include "transfer/packed_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "transfer/preintegration.h"

namespace havs {
namespace {

ExtinctionCurve presetCurve(const std::string& name) {
  return withoutOpaque(makeCurve(loadTransferFunction(name), {}));
}

/// Steps everywhere, at both ends too, and knots that lie a few 1e-12 from one another.
ExtinctionCurve hardCurve() {
  ExtinctionCurve curve;
  curve.knots = {{0, {1, 0, 0}, 5},         {0, {0, 1, 0}, 1},           {0.25, {0, 1, 0}, 3},
                 {0.25, {1, 1, 0}, 0},      {0.5 - 1e-12, {1, 0, 1}, 2}, {0.5 + 2e-12, {0, 0, 1}, 9},
                 {0.7, {1, 0.2, 0.3}, 0},   {0.75, {1, 0.2, 0.3}, 0},    {0.7500001, {0, 1, 1}, 40},
                 {0.7500002, {1, 1, 1}, 0}, {1, {0, 0, 1}, 4},           {1, {1, 1, 1}, 2}};
  return curve;
}

struct Case {
  float front, back, length;
};

/// Segments of all lengths, short and long spans, scalars on knots and next to them, equal ends.
std::vector<Case> cases(const ExtinctionCurve& curve) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<Case> list;
  for (int i = 0; i < 20000; ++i) {
    const float length = std::pow(10.0F, -4 + 4.5F * unit(random));
    float front = unit(random), back = unit(random);
    if (i % 3 == 0) back = front + (unit(random) - 0.5F) * 0.02F;
    if (i % 7 == 0) front = static_cast<float>(curve.knots[random() % curve.knots.size()].s);
    if (i % 11 == 0) back = static_cast<float>(curve.knots[random() % curve.knots.size()].s);
    if (i % 13 == 0) back = front;
    if (i % 17 == 0) back = std::nextafter(front, 2.0F);
    list.push_back({std::clamp(front, 0.0F, 1.0F), std::clamp(back, 0.0F, 1.0F), length});
  }
  return list;
}

template <class C>
double distance(const C& got, const SegmentColor& exact) {
  return std::max({std::abs(got.r - exact.color[0]), std::abs(got.g - exact.color[1]), std::abs(got.b - exact.color[2]),
                   std::abs(got.a - exact.alpha)});
}

std::vector<std::pair<std::string, ExtinctionCurve>> curves() {
  std::vector<std::pair<std::string, ExtinctionCurve>> list{{"hard", hardCurve()}};
  for (const TransferPreset& preset : transferPresets()) list.emplace_back(preset.name, presetCurve(preset.name));
  return list;
}

template <class Lane>
double worstOfExact(const ExtinctionCurve& curve) {
  using Real = typename Lane::Real;
  const PackedCurve<Real> packed = packCurve<Real>(curve);
  const CurveFetch<Lane> fetch(packed);
  double worst = 0;
  for (const Case& c : cases(curve)) {
    const double d = distance(Arithmetic<Lane>::exactSegment(fetch, Real(c.front), Real(c.back), Real(c.length)),
                              integrateSegment(curve, c.front, c.back, c.length));
    if (d > worst) worst = d;
  }
  return worst;
}

TEST(ExactLookup, IsTheSegmentsIntegral) {
  for (const auto& [name, curve] : curves()) {
    const double inDouble = worstOfExact<DoubleLane>(curve), inFloat = worstOfExact<FloatLane>(curve);
    RecordProperty(name, std::to_string(inDouble * 1e15) + "e-15, float " + std::to_string(inFloat * 1e7) + "e-7");
    printf("%s %g %g\n", name.c_str(), inDouble, inFloat);
    EXPECT_LE(inDouble, 1e-13) << name;
    EXPECT_LE(inFloat, 1e-6) << name;
  }
}

}  // namespace
}  // namespace havs
