#pragma once
// Light that is scattered in a homogeneous ball, followed from the ball's centre outwards: the simulation behind
// light/scattering_table.h.
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace havs {

/// Orders of scattering that are kept apart; all beyond are one.
inline constexpr std::size_t kScatteringOrders = 32;
/// Ranges of the exit direction, kept for each order n in equal shares of Henyey-Greenstein's function of g^n: which
/// light scattered n times would follow without the ball's boundary, so that each range gets about as much.
inline constexpr std::size_t kScatteringShares = 16;

/// What a number of walks have left the ball with, of light that is scattered at least twice; all of it sums to 1.
struct BallLight {
  /// exits[n - 2][i]: light of order n, 2 to kScatteringOrders, and as the last of all beyond, in range i.
  std::array<std::array<double, kScatteringShares>, kScatteringOrders> exits{};
  /// Of the light beyond, the mean of n - kScatteringOrders; at least 1.
  double meanBeyond = 1;
};

/// A ball of optical radius `radius` > 0, asymmetry g, albedo 1; `walks` > 0. Walks are numbered from `firstWalk`, each
/// with random numbers of its own.
BallLight walkBall(double radius, double g, std::size_t walks, std::uint64_t seed, std::uint64_t firstWalk);

}  // namespace havs
