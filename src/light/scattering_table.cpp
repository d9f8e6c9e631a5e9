#include "light/scattering_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/error.h"
#include "core/parallel.h"
#include "light/henyey_greenstein.h"

namespace havs {
namespace {

constexpr double kLeastRadius = 1e-6;  ///< stands for 0, where light leaves with the second order

void check(const ScatteringSetting& setting) {
  if (!(std::abs(setting.g) <= 0.99))
    failInput(fmt::format("asymmetry {} of scattering is not between -0.99 and 0.99", setting.g), "",
              "0 scatters evenly, 0.8 forwards");
  if (setting.walks < ScatteringTable::kBatches)
    failInput(fmt::format("{} walks are too few", setting.walks), "",
              fmt::format("give at least {}", ScatteringTable::kBatches));
}

void checkAlbedo(double albedo) {
  if (!(albedo >= 0 && albedo <= 1))
    failInput(fmt::format("albedo {} of scattering is not between 0 and 1", albedo), "", "0 absorbs all light");
}

/// Calls change(to, from) for the entries of both.
template <class Exits, class Change>
void eachEntry(Exits& to, const Exits& from, const Change& change) {
  for (std::size_t n = 0; n < to.size(); ++n)
    for (std::size_t i = 0; i < to[n].size(); ++i) change(to[n][i], from[n][i]);
}

}  // namespace

/// Dense where the shares of the orders change fast.
double ScatteringTable::radius(std::size_t i) {
  const double x = static_cast<double>(i) / static_cast<double>(kRadii - 1);
  return kGreatestRadius * x * x;
}

ScatteringTable::Place ScatteringTable::placeOf(double tau) {
  const double x = std::sqrt(std::clamp(tau / kGreatestRadius, 0.0, 1.0)) * static_cast<double>(kRadii - 1);
  const std::size_t low = std::min(static_cast<std::size_t>(x), kRadii - 2);
  const double share = (tau - radius(low)) / (radius(low + 1) - radius(low));
  return {low, std::clamp(share, 0.0, 1.0)};
}

ScatteringTable::ScatteringTable(const ScatteringSetting& setting) : g_(setting.g), nodes_(kRadii), errors_(kRadii) {
  check(setting);
  const std::size_t walks = setting.walks / kBatches;
  std::vector<BallLight> batches(kRadii * kBatches);
  parallelFor(0, batches.size(), 1, [&](std::size_t i) {
    const std::size_t number = batches.size() - 1 - i;  // large radii take longest, so they come first
    batches[number] =
        walkBall(std::max(kLeastRadius, radius(number / kBatches)), g_, walks, setting.seed, number * walks);
  });
  constexpr auto kCount = static_cast<double>(kBatches);
  for (std::size_t i = 0; i < kRadii; ++i) {
    const BallLight* batch = &batches[i * kBatches];
    BallLight& mean = nodes_[i];
    mean.meanBeyond = 0;
    double beyond = 0;
    for (std::size_t b = 0; b < kBatches; ++b) {
      eachEntry(mean.exits, batch[b].exits, [](double& sum, double exit) { sum += exit / kCount; });
      for (const double exit : batch[b].exits.back()) {
        beyond += exit;
        mean.meanBeyond += exit * batch[b].meanBeyond;
      }
    }
    mean.meanBeyond = beyond > 0 ? std::max(1.0, mean.meanBeyond / beyond) : 1;
    decltype(BallLight::exits) squares{};
    for (std::size_t b = 0; b < kBatches; ++b) {
      auto deviation = batch[b].exits;
      eachEntry(deviation, mean.exits, [](double& exit, double average) { exit -= average; });
      eachEntry(squares, deviation, [](double& sum, double d) { sum += d * d; });
    }
    eachEntry(errors_[i], squares, [](double& e, double s) { e = std::sqrt(s / (kCount * (kCount - 1))); });
  }
}

/// Density over the share, linear between the ranges' middles: integrates to the sum of the ranges.
double ScatteringTable::inRange(const std::array<double, kScatteringShares>& ranges, double share) {
  constexpr auto kCount = static_cast<double>(kScatteringShares);
  const double x = std::clamp(share * kCount - 0.5, 0.0, kCount - 1);
  const std::size_t low = std::min(static_cast<std::size_t>(x), kScatteringShares - 2);
  return kCount * std::lerp(ranges[low], ranges[low + 1], x - static_cast<double>(low));
}

double ScatteringTable::density(std::size_t order, double tau, double cosine) const {
  if (order == 1) return henyeyGreenstein(g_, cosine) * std::exp(-tau);
  const double g = std::pow(g_, static_cast<double>(order));
  const double share = henyeyGreensteinShare(g, cosine);
  const Place place = placeOf(tau);
  const double low = inRange(nodes_[place.low].exits[order - 2], share);
  const double high = inRange(nodes_[place.low + 1].exits[order - 2], share);
  return henyeyGreenstein(g, cosine) * -std::expm1(-tau) * std::lerp(low, high, place.share);
}

double ScatteringTable::error(std::size_t order, double tau, double cosine) const {
  if (order == 1) return 0;
  const double g = std::pow(g_, static_cast<double>(order));
  const Place place = placeOf(tau);
  const auto& ranges = errors_[place.share < 0.5 ? place.low : place.low + 1][order - 2];
  return henyeyGreenstein(g, cosine) * -std::expm1(-tau) * inRange(ranges, henyeyGreensteinShare(g, cosine));
}

double ScatteringTable::albedoBeyond(double tau, double albedo) const {
  // With m the mean of j, order kScatteringOrders + j has the share (1 - 1/m)^(j-1) / m: a geometric series.
  const Place place = placeOf(tau);
  const double m = std::lerp(nodes_[place.low].meanBeyond, nodes_[place.low + 1].meanBeyond, place.share);
  return std::pow(albedo, static_cast<double>(kScatteringOrders)) *
         (albedo > 0 ? albedo / (m * (1 - albedo) + albedo) : 0);
}

double ScatteringTable::sum(double albedo, double tau, double cosine) const {
  checkAlbedo(albedo);
  double total = 0, power = 1;
  for (std::size_t order = 1; order <= kScatteringOrders; ++order)
    total += (power *= albedo) * density(order, tau, cosine);
  return total + albedoBeyond(tau, albedo) * density(kScatteringOrders + 1, tau, cosine);
}

std::shared_ptr<const ScatteringTable> scatteringTableOf(double g) {
  static std::mutex mutex;
  static std::shared_ptr<const ScatteringTable> last;
  const std::lock_guard lock(mutex);
  if (!last || last->g() != g) last = std::make_shared<ScatteringTable>(ScatteringSetting{.g = g});
  return last;
}

ScatteredLight::ScatteredLight(const ScatteringTable& table, double albedo)
    : g_(table.g()), albedo_(albedo), ratio_(ScatteringTable::kRadii * kAngles) {
  checkAlbedo(albedo);
  parallelFor(0, ScatteringTable::kRadii, 1, [&](std::size_t radius) {
    const double tau = std::max(kLeastRadius, ScatteringTable::radius(radius));
    for (std::size_t angle = 0; angle < kAngles; ++angle) {
      const double x = static_cast<double>(angle) / (kAngles - 1);
      const double cosine = std::copysign(1.0, g_) * std::cos(std::numbers::pi * x * x);
      const double more = table.sum(albedo, tau, cosine) - albedo * table.density(1, tau, cosine);
      ratio_[radius * kAngles + angle] = more / (henyeyGreenstein(g_, cosine) * -std::expm1(-tau));
    }
  });
}

double ScatteredLight::operator()(double tau, double cosine) const {
  const double fromPeak = std::acos(std::clamp(std::copysign(1.0, g_) * cosine, -1.0, 1.0));
  const double x = std::sqrt(fromPeak / std::numbers::pi) * (kAngles - 1);
  const std::size_t angle = std::min(static_cast<std::size_t>(x), kAngles - 2);
  const auto [low, share] = ScatteringTable::placeOf(tau);
  const auto at = [&, share = x - static_cast<double>(angle)](std::size_t radius) {
    const double* row = &ratio_[radius * kAngles + angle];
    return std::lerp(row[0], row[1], share);
  };
  return henyeyGreenstein(g_, cosine) *
         (albedo_ * std::exp(-tau) - std::expm1(-tau) * std::lerp(at(low), at(low + 1), share));
}

}  // namespace havs
