// A walk is scattered at the centre for the first time. On its way to each next scattering the part of its light that
// would leave the ball does, and what is left goes on; so every walk has something to say about every order, and no
// light is lost. Beyond the last order light leaves the ball as a whole, of one walk in kThinning.
#include "light/ball_walk.h"

#include <algorithm>
#include <cmath>

#include "core/vec.h"
#include "light/counter_random.h"
#include "light/henyey_greenstein.h"

namespace havs {
namespace {

constexpr double kThinning = 2;
/// Light so little leaves with the order it has.
constexpr double kLeast = 1e-9;
/// Scatterings of a walk at most: a thousand times what a ball of the greatest radius of the table needs.
constexpr int kMost = 1000000;

/// How far it is from inside the ball to its surface.
double wayOut(const Vec3& place, const Vec3& direction, double radius) {
  const double along = dot(place, direction);
  const double room = std::max(0.0, radius * radius - dot(place, place));
  const double root = std::sqrt(along * along + room);
  return along > 0 ? room / (along + root) : root - along;
}

Vec3 scattered(const Vec3& direction, double g, CounterRandom& random) {
  const double cosine = henyeyGreensteinCosine(g, random.next());
  const double sine = std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine)));
  const double angle = 2 * std::numbers::pi * random.next();
  // A basis across the direction (Duff et al. 2017, Building an Orthonormal Basis, Revisited).
  const double sign = std::copysign(1.0, direction.z);
  const double a = -1 / (sign + direction.z), b = direction.x * direction.y * a;
  const Vec3 x{1 + sign * direction.x * direction.x * a, sign * b, -sign * direction.x};
  const Vec3 y{b, sign + direction.y * direction.y * a, -direction.y};
  return normalize(cosine * direction + sine * (std::cos(angle) * x + std::sin(angle) * y));
}

class Walks {
 public:
  Walks(double radius, double g) : radius_(radius), g_(g) {
    double power = g;
    for (double& p : powers_) p = power *= g;  // of order 2 and on
  }

  /// `share` of the first direction, which is about the axis z.
  void walk(double share, CounterRandom& random) {
    const double cosine = henyeyGreensteinCosine(g_, share);
    Vec3 direction{std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine))), 0, cosine};
    Vec3 place{0};
    double light = 1;
    double way = radius_;
    for (std::size_t order = 2; order <= kScatteringOrders; ++order) {
      place += -std::log1p(random.next() * std::expm1(-way)) * direction;
      direction = scattered(direction, g_, random);
      way = wayOut(place, direction, radius_);
      const double stays = -light * std::expm1(-way);
      if (stays < kLeast) return leave(order, direction, light);
      leave(order, direction, light - stays);
      light = stays;
    }
    beyond_ += light;
    if (random.next() * kThinning < 1) walkBeyond(place, direction, way, light, random);
  }

  BallLight light(std::size_t walks) const {
    BallLight result = light_;
    auto& last = result.exits.back();
    for (double& exit : last) exit *= left_ > 0 ? beyond_ / left_ : 0;
    if (!(left_ > 0)) last.fill(beyond_ / kScatteringShares);
    result.meanBeyond = left_ > 0 ? leftOrders_ / left_ : 1;
    for (auto& order : result.exits)
      for (double& exit : order) exit /= static_cast<double>(walks);
    return result;
  }

 private:
  void leave(std::size_t order, const Vec3& direction, double light) {
    const double share = henyeyGreensteinShare(powers_[order - 2], std::clamp(direction.z, -1.0, 1.0));
    const auto range = static_cast<std::size_t>(std::max(0.0, share * kScatteringShares));
    light_.exits[order - 2][std::min(range, kScatteringShares - 1)] += light;
  }

  void walkBeyond(Vec3 place, Vec3 direction, double way, double light, CounterRandom& random) {
    double step = -std::log1p(random.next() * std::expm1(-way));  // it does not leave with the last order
    int beyond = 0;
    do {
      place += step * direction;
      direction = scattered(direction, g_, random);
      way = wayOut(place, direction, radius_);
      step = -std::log(random.next());
      ++beyond;
    } while (step < way && beyond < kMost);
    leave(kScatteringOrders + 1, direction, light);
    left_ += light;
    leftOrders_ += light * beyond;
  }

  double radius_, g_;
  std::array<double, kScatteringOrders> powers_;
  BallLight light_;
  double beyond_ = 0;                 ///< light of orders beyond the last
  double left_ = 0, leftOrders_ = 0;  ///< of it, what was followed, and times its orders beyond the last
};

}  // namespace

BallLight walkBall(double radius, double g, std::size_t walks, std::uint64_t seed, std::uint64_t firstWalk) {
  Walks all(radius, g);
  for (std::size_t i = 0; i < walks; ++i) {
    CounterRandom random(seed, firstWalk + i);
    const double share = (static_cast<double>(i) + random.next()) / static_cast<double>(walks);
    all.walk(share, random);
  }
  return all.light(walks);
}

}  // namespace havs
