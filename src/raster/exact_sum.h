#pragma once
// Sums of products of doubles without rounding, as expansions: parts that do not overlap, small ones first (Shewchuk,
// Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997, section 2).
#include <array>
#include <cmath>
#include <cstddef>

namespace havs {

/// A sum of up to `kMost` doubles, exact unless a product overflows or its last bits underflow.
template <std::size_t kMost>
class ExactSum {
 public:
  void add(double value) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const Pair pair = twoSum(value, parts_[i]);
      value = pair.high;
      if (pair.low != 0) parts_[kept++] = pair.low;
    }
    if (value != 0) parts_[kept++] = value;
    count_ = kept;
  }
  void addProduct(double a, double b) {
    const Pair pair = twoProduct(a, b);
    add(pair.low);
    add(pair.high);
  }
  void addProduct(double a, double b, double c) {
    const Pair pair = twoProduct(a, b);
    addProduct(pair.low, c);
    addProduct(pair.high, c);
  }

  /// The sum to the last bits; its sign is exact, and it is 0 only where the sum is.
  double value() const {
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i) sum += parts_[i];
    return sum;
  }

 private:
  struct Pair {
    double high, low;
  };
  static Pair twoSum(double a, double b) {
    const double sum = a + b;
    const double rounded = sum - a;
    return {sum, (a - (sum - rounded)) + (b - rounded)};
  }
  static Pair twoProduct(double a, double b) {
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
  }

  std::array<double, kMost> parts_{};
  std::size_t count_ = 0;
};

}  // namespace havs
