#include "transfer/packed_curve.h"

#include <cmath>

namespace havs {
namespace {

using Knot = ExtinctionCurve::Knot;

constexpr std::size_t kFewestCells = 1024, kMostCells = 65536, kCellsPerPiece = 8;
constexpr double kBeyondOne = 1e-30;

template <class Number>
struct Split {
  Number head;
  Number tail;
  explicit Split(long double x) : head(static_cast<Number>(x)), tail(static_cast<Number>(x - head)) {}
  bool operator==(const Split&) const = default;
};

template <class Number>
class Packer {
 public:
  PackedCurve<Number> pack(const ExtinctionCurve& curve) {
    const auto& knots = curve.knots;
    for (std::size_t i = 1; i < knots.size(); ++i) addPiece(knots[i - 1], knots[i]);
    const Knot& last = knots.back();
    if (knots.size() > 1 && knots[knots.size() - 2].s == last.s) {  // a step at 1: its upper side holds there
      Knot beyond = last;
      beyond.s = 2;
      addPiece(last, beyond);
    } else {
      packed_.pieces[packed_.pieces.size() - 3][3] = static_cast<Number>(kBeyondOne);
    }
    makeGuide();
    return std::move(packed_);
  }

 private:
  using Texel = typename PackedCurve<Number>::Texel;

  void addPiece(const Knot& low, const Knot& high) {
    const Split<Number> from(low.s), to(high.s);
    if (from == to) return;  // a step, or knots too close to be told apart
    packed_.pieces.push_back({from.head, from.tail, to.head, to.tail});
    packed_.pieces.push_back(texel(low.color, low.kappa));
    packed_.pieces.push_back(texel(high.color, high.kappa));
    addIntegrals(low, high);
  }

  static Texel texel(const std::array<double, 3>& color, double kappa) {
    return {static_cast<Number>(color[0]), static_cast<Number>(color[1]), static_cast<Number>(color[2]),
            static_cast<Number>(kappa)};
  }

  /// The integrals up to `low`, then on to `high`.
  void addIntegrals(const Knot& low, const Knot& high) {
    const Split<Number> depth(depth_);
    packed_.integrals.push_back(
        {static_cast<Number>(low.kappa), static_cast<Number>(high.kappa), depth.head, depth.tail});
    Texel head{}, tail{};
    const long double extent = static_cast<long double>(high.s) - low.s;
    for (std::size_t c = 0; c < 3; ++c) {
      const Split<Number> light(light_[c]);
      head[c] = light.head;
      tail[c] = light.tail;
      light_[c] += extent / 6 *
                   (low.color[c] * (2.0L * low.kappa + high.kappa) + high.color[c] * (low.kappa + 2.0L * high.kappa));
    }
    packed_.integrals.push_back(head);
    packed_.integrals.push_back(tail);
    depth_ += extent / 2 * (static_cast<long double>(low.kappa) + high.kappa);
  }

  void makeGuide() {
    const std::size_t count = packed_.pieces.size() / 3;
    std::size_t cells = kFewestCells;
    while (cells < kMostCells && cells < kCellsPerPiece * count) cells *= 2;
    packed_.guide.resize(cells);
    std::size_t piece = 0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
      const double s = static_cast<double>(cell) / static_cast<double>(cells);
      while (piece + 1 < count && beginsAtOrBefore(piece + 1, s)) ++piece;
      packed_.guide[cell] = static_cast<Number>(piece);
    }
  }
  bool beginsAtOrBefore(std::size_t piece, double s) const {
    const Texel& place = packed_.pieces[3 * piece];
    return static_cast<double>(place[0]) + static_cast<double>(place[1]) <= s;
  }

  PackedCurve<Number> packed_;
  long double depth_ = 0;
  std::array<long double, 3> light_{0, 0, 0};
};

}  // namespace

template <class Number>
PackedCurve<Number> packCurve(const ExtinctionCurve& curve) {
  return Packer<Number>().pack(curve);
}

template PackedCurve<float> packCurve(const ExtinctionCurve& curve);
template PackedCurve<double> packCurve(const ExtinctionCurve& curve);

}  // namespace havs
