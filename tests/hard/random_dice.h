#pragma once
// Random numbers that are the same with every standard library: the engine is the standard's, the rest is here.
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "core/vec.h"

namespace havs::test {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  /// Of case `number` of a run.
  Dice(std::uint64_t seed, std::uint64_t number) : engine_(seed * 0x9E3779B97F4A7C15ull + number) {
    engine_.discard(8);
  }

  /// Of [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// Of low to high, any order of magnitude as likely as another.
  double magnitude(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  /// Of 0 to count - 1.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  /// Of low to high, both included.
  int whole(int low, int high) { return low + static_cast<int>(below(static_cast<std::size_t>(high - low + 1))); }
  bool chance(double probability) { return unit() < probability; }
  template <class Value>
  const Value& of(const std::vector<Value>& values) {
    return values[below(values.size())];
  }
  Vec3 inCube(double half) {
    const double x = between(-half, half), y = between(-half, half), z = between(-half, half);
    return {x, y, z};
  }
  /// Of length 1.
  Vec3 direction() {
    while (true) {
      const Vec3 v = inCube(1);
      if (const double l = length(v); l > 0.1 && l <= 1) return v / l;
    }
  }
  template <class Value>
  void shuffle(std::vector<Value>& values) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[below(i)]);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace havs::test
