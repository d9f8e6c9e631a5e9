#pragma once
// Light scattered around a point, as if the point lay in the middle of a homogeneous ball (Ament, Sadlo, Weiskopf 2013,
// Ambient Volume Scattering). P_n(tau, g, cos theta): a walk starts at the centre of a ball of optical radius tau; its
// first direction is drawn by Henyey and Greenstein's function of asymmetry g about the view ray, and so is each
// further one about the last; nothing is absorbed. n is the number of scatterings, the one at the centre included,
// theta the angle between the direction in which the walk leaves the ball and the view ray; P_n is a density per
// steradian. All orders together integrate to 1 over the sphere.
//
// The first order is known, henyeyGreenstein(g, cos theta) exp(-tau); the others are simulated. What they share of
// 1 - exp(-tau) is tabulated, so that the limit of a small ball is exact.
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "light/ball_walk.h"

namespace havs {

struct ScatteringSetting {
  double g = 0;               ///< asymmetry, -0.99 to 0.99
  std::size_t walks = 32768;  ///< for each radius of the table; at least kBatches
  std::uint64_t seed = 1;
};

/// P_n for one g (a scene has one): of every order up to kScatteringOrders, and of all beyond together. cosine: -1
/// to 1.
class ScatteringTable {
 public:
  static constexpr std::size_t kRadii = 49;
  static constexpr double kGreatestRadius = 16;  ///< beyond it the shares stay; less than 1e-6 is of the first order
  static constexpr std::size_t kBatches = 16;    ///< of walks, whose spread tells the error

  /// Simulates: seconds. Throws Error{input} for settings out of range. Parallel; the result does not depend on the
  /// number of threads.
  explicit ScatteringTable(const ScatteringSetting& setting);

  double g() const { return g_; }
  /// P_n at an optical radius tau >= 0; order: 1 to kScatteringOrders, or kScatteringOrders + 1 for all beyond.
  double density(std::size_t order, double tau, double cosine) const;
  /// Standard error of that, estimated from the spread of batches of walks, of the nearer of the tabulated radii.
  double error(std::size_t order, double tau, double cosine) const;
  /// The sum of albedo^n over the light of all orders beyond, as a share of it: their light is taken to fade from order
  /// to order by one factor, whose mean order was simulated. albedo: 0 to 1.
  double albedoBeyond(double tau, double albedo) const;
  /// The sum of albedo^n P_n over all orders.
  double sum(double albedo, double tau, double cosine) const;

  /// Optical radius i of the table, and where others lie between two of them.
  static double radius(std::size_t i);
  struct Place {
    std::size_t low;
    double share;  ///< of low + 1
  };
  static Place placeOf(double tau);

 private:
  static double inRange(const std::array<double, kScatteringShares>& ranges, double share);

  double g_;
  std::vector<BallLight> nodes_;                    ///< one a radius
  std::vector<decltype(BallLight::exits)> errors_;  ///< standard errors of nodes_
};

/// The table of the default walks and seed for an asymmetry. The last one asked for is kept: it depends on nothing
/// else, so that several renderers of a scene share it. From any number of threads. Throws Error{input}.
std::shared_ptr<const ScatteringTable> scatteringTableOf(double g);

/// The sum of a table for one albedo, ready to be looked up for many points. Off from ScatteringTable::sum by a
/// fraction of the table's own noise, whose corners it cuts (docs/08-effects-data.md).
class ScatteredLight {
 public:
  /// albedo: 0 to 1; throws Error{input} for others.
  ScatteredLight(const ScatteringTable& table, double albedo);
  /// Per steradian.
  double operator()(double tau, double cosine) const;

 private:
  static constexpr std::size_t kAngles = 513;
  double g_, albedo_;
  /// Of what is scattered more than once to henyeyGreenstein(g); kAngles a radius, dense about the peak: angle i is
  /// pi (i / (kAngles - 1))^2 from it.
  std::vector<double> ratio_;
};

}  // namespace havs
