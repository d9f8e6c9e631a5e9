#include "transfer/grid_pieces.h"

#include "core/parallel.h"

namespace havs {
namespace {

/// Gauss-Legendre on [0, 1]: exact for polynomials up to degree 23. An integrand here has degree 2 + 2 n, and what is
/// left of the higher ones is divided by n!.
constexpr int kNodes = 12;
constexpr double kNode[kNodes] = {0.0092196828766403746547, 0.0479413718147625716608, 0.1150486629028476564816,
                                  0.2063410228566912763517, 0.3160842505009099031236, 0.4373832957442655422638,
                                  0.5626167042557344577362, 0.6839157494990900968764, 0.7936589771433087236483,
                                  0.8849513370971523435184, 0.9520586281852374283392, 0.9907803171233596253453};
constexpr double kWeight[kNodes] = {0.0235876681932559135973, 0.0534696629976592154801, 0.0800391642716731131673,
                                    0.1015837133615329608745, 0.1167462682691774043804, 0.1245735229067013902500,
                                    0.1245735229067013902500, 0.1167462682691774043804, 0.1015837133615329608745,
                                    0.0800391642716731131673, 0.0534696629976592154801, 0.0235876681932559135973};

/// Adds the moments of a piece that begins at the share `before` of the step's depth, to four lanes from `first`.
/// `atFront`, `atBack`: (r, g, b, optical slope), the slope as a share of the step's depth.
void addMoments(const Rgba& atFront, const Rgba& atBack, double before, std::size_t first, StepSeries& series) {
  for (int node = 0; node < kNodes; ++node) {
    const double s = kNode[node];
    const double slope = (1 - s) * atFront.a + s * atBack.a;
    const double y = before + 0.5 * s * (atFront.a + slope);
    double light = kWeight[node] * slope;
    for (int n = 0; n < StepSeries::kTerms; ++n) {
      series.moment[n].value[first] += ((1 - s) * atFront.r + s * atBack.r) * light;
      series.moment[n].value[first + 1] += ((1 - s) * atFront.g + s * atBack.g) * light;
      series.moment[n].value[first + 2] += ((1 - s) * atFront.b + s * atBack.b) * light;
      light *= y / (n + 1);
    }
  }
}

/// x times the alternating sum of `terms` moments. Rounding must not carry a colour beyond its opacity.
inline __attribute__((always_inline)) void evaluate(const StepSeries& series, double x, int terms, Lanes& result) {
  LaneVector sum, moment;
  load(series.moment[terms - 1], sum);
  for (int n = terms - 2; n >= 0; --n) {
    load(series.moment[n], moment);
    sum = moment - x * sum;
  }
  sum = x * sum;
  const LaneVector alpha = __builtin_shufflevector(sum, sum, 3, 3, 3, 3, 7, 7, 7, 7);
  store(sum < alpha ? sum : alpha, result);
}

/// Those of [begin, end) that are not too deep for it.
HAVS_FOR_WIDEST_LANES void evaluateShallow(const StepSeries* series, int begin, int end, double lengthPerScalar,
                                           Lanes* result) {
  for (int i = begin; i < end; ++i) {
    const double x = series[i].depth * lengthPerScalar;
    if (x <= StepSeries::kShallowDepth)
      evaluate(series[i], x, StepSeries::kShallowTerms, result[i]);
    else if (x <= StepSeries::kDeepest)
      evaluate(series[i], x, StepSeries::kTerms, result[i]);
  }
}

}  // namespace

GridPieces::GridPieces(const ExtinctionCurve& curve, int lines, double added)
    : curve_(curve), lines_(lines), added_(added) {
  const int count = lines - 1;
  for (int i = 0; i < count; ++i) {
    first_.push_back(pieces_.size());
    double depth = 0;
    visitPieces(curve, static_cast<double>(i) / count, static_cast<double>(i + 1) / count,
                [&](const Rgba& low, const Rgba& high, double extent) {
                  pieces_.push_back({low, high, extent});
                  depth += 0.5 * (low.a + high.a) * extent;
                });
    depths_.push_back(depth);
  }
  first_.push_back(pieces_.size());
  series_.resize(static_cast<std::size_t>(count));
  parallelFor(0, series_.size(), 8, [&](std::size_t i) { series_[i] = seriesOf(static_cast<int>(i)); });
}

StepSeries GridPieces::seriesOf(int step) const {
  StepSeries series{};
  const auto slope = [&](const Rgba& end, double extent) { return (end.a + added_) * extent; };
  const std::size_t begin = first_[step], end = first_[step + 1];
  for (std::size_t p = begin; p < end; ++p)
    series.depth += 0.5 * (slope(pieces_[p].low, pieces_[p].extent) + slope(pieces_[p].high, pieces_[p].extent));
  double factorial = 1;
  for (int n = 0; n < StepSeries::kTerms; ++n) {
    factorial *= n + 1;
    series.moment[n].value[3] = series.moment[n].value[7] = 1 / factorial;
  }
  if (!(series.depth > 0 && std::isfinite(series.depth))) return series;
  const auto share = [&](const Rgba& at, double extent) {
    return Rgba(at.r, at.g, at.b, slope(at, extent) / series.depth);
  };
  double before = 0;
  for (std::size_t p = begin; p < end; ++p) {
    const Rgba low = share(pieces_[p].low, pieces_[p].extent), high = share(pieces_[p].high, pieces_[p].extent);
    addMoments(low, high, before, 0, series);
    before += 0.5 * (low.a + high.a);
  }
  before = 0;
  for (std::size_t p = end; p-- > begin;) {
    const Rgba low = share(pieces_[p].low, pieces_[p].extent), high = share(pieces_[p].high, pieces_[p].extent);
    addMoments(high, low, before, 4, series);
    before += 0.5 * (low.a + high.a);
  }
  return series;
}

void GridPieces::steps(int begin, int end, double lengthPerScalar, Lanes* result) const {
  evaluateShallow(series_.data(), begin, end, lengthPerScalar, result);
  for (int i = begin; i < end; ++i) {
    if (series_[i].depth * lengthPerScalar <= StepSeries::kDeepest) continue;
    const Rgba up = composite(i, true, lengthPerScalar), down = composite(i, false, lengthPerScalar);
    result[i] = {{up.r, up.g, up.b, up.a, down.r, down.g, down.b, down.a}};
  }
}

Rgba GridPieces::composite(int step, bool ascending, double lengthPerScalar) const {
  const auto plus = [&](const Rgba& at) { return Rgba(at.r, at.g, at.b, at.a + added_); };
  Rgba sum(0, 0, 0, 0);
  for (std::size_t p = first_[step]; p < first_[step + 1]; ++p) {
    const Rgba low = plus(pieces_[p].low), high = plus(pieces_[p].high);
    const double length = pieces_[p].extent * lengthPerScalar;
    sum = ascending ? DoubleArithmetic::compositeUnder(sum, integratePiece(low, high, length))
                    : DoubleArithmetic::compositeUnder(integratePiece(high, low, length), sum);
  }
  return sum;
}

Stretch GridPieces::atLine(int i, double length) const {
  const ExtinctionCurve::Knot k = curve_.at(static_cast<double>(i) / (lines_ - 1));
  const Rgba sample(k.color[0], k.color[1], k.color[2], k.kappa + added_);
  return {integratePiece(sample, sample, length), k.kappa * length};
}

}  // namespace havs
