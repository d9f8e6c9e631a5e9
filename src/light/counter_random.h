#pragma once
#include <cstdint>

namespace havs {

/// Random numbers that depend on a seed, the number of a stream and their place in it only: every walk of a simulation
/// has its own, whichever thread takes it. The mixer is that of SplitMix64 (Steele, Lea, Flood 2014, Fast Splittable
/// Pseudorandom Number Generators).
class CounterRandom {
 public:
  CounterRandom(std::uint64_t seed, std::uint64_t stream) : state_(mixed(mixed(seed + kStep) ^ (stream * kStep))) {}

  /// Between 0 and 1, neither of them included.
  double next() {
    state_ += kStep;
    return (static_cast<double>(mixed(state_) >> 12) + 0.5) * 0x1p-52;
  }

 private:
  static constexpr std::uint64_t kStep = 0x9E3779B97F4A7C15u;
  static std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
  }
  std::uint64_t state_;
};

}  // namespace havs
