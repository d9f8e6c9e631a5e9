#pragma once
// A curve as shaders/core/curve.glsl and core/integral_functions.glsl read it.
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/arithmetic.h"
#include "transfer/extinction_curve.h"

namespace havs {

/// The pieces of a curve, four numbers a texel. With float numbers a knot's place and the integral functions are kept
/// to 48 bits, as head and tail.
template <class Number>
struct PackedCurve {
  using Texel = std::array<Number, 4>;
  /// The number of the last piece that begins at each of guide.size() equal cells of [0, 1]; a power of two.
  std::vector<Number> guide;
  /// Three texels a piece, ascending: (head, tail of the lower end, head, tail of the upper end); (r, g, b, kappa) at
  /// the lower end; at the upper end. The last ends a little beyond 1.
  std::vector<Texel> pieces;
  /// Three texels a piece: (kappa at the lower end, at the upper end, head, tail of the integral of kappa from 0 to the
  /// lower end); head of the integral of colour times kappa; its tail.
  std::vector<Texel> integrals;
};

template <class Number>
PackedCurve<Number> packCurve(const ExtinctionCurve& curve);

/// The fetch functions of the shaders' arithmetic over a packed curve, which must outlive it.
template <class Lane>
class CurveFetch {
 public:
  using Number = typename Lane::Real;
  using Rgba = typename Arithmetic<Lane>::Rgba;

  explicit CurveFetch(const PackedCurve<Number>& curve) : curve_(curve) {}

  Number pieceNear(Number s) const {
    const std::size_t cells = curve_.guide.size();
    return curve_.guide[std::min(static_cast<std::size_t>(s * static_cast<Number>(cells)), cells - 1)];
  }
  Rgba piecePlace(Number piece) const { return at(curve_.pieces, piece, 0); }
  Rgba pieceLow(Number piece) const { return at(curve_.pieces, piece, 1); }
  Rgba pieceHigh(Number piece) const { return at(curve_.pieces, piece, 2); }
  Rgba pieceExtinction(Number piece) const { return at(curve_.integrals, piece, 0); }
  Rgba lightHead(Number piece) const { return at(curve_.integrals, piece, 1); }
  Rgba lightTail(Number piece) const { return at(curve_.integrals, piece, 2); }

 private:
  static Rgba at(const std::vector<std::array<Number, 4>>& texels, Number piece, std::size_t which) {
    const auto& t = texels[3 * static_cast<std::size_t>(piece) + which];
    return {t[0], t[1], t[2], t[3]};
  }
  const PackedCurve<Number>& curve_;
};

}  // namespace havs
