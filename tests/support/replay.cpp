#include "support/replay.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/arithmetic.h"
#include "core/parallel.h"
#include "support/fragments.h"

namespace havs::test {
namespace {

/// What replaying one pixel gave.
struct PixelResult {
  Rgba color{};
  std::size_t misordered = 0;
  bool negative = false;
  double longestSegment = 0;
};

template <int K>
class PixelReplay {
  using A = Arithmetic<DoubleLane, K>;

 public:
  explicit PixelReplay(const SegmentColor& color) : color_(color) {
    for (auto& entry : buffer_.entry) entry = A::emptyFragment();
  }

  void add(const ExactFragment& exact) {
    const typename A::Fragment fragment = A::makeFragment(exact.scalar, exact.distance, exact.kind);
    if (A::isLate(buffer_, state_, fragment)) {
      ++result_.misordered;
      state_.inside += exact.kind;  // the fragment is dropped, its kind still counts
      return;
    }
    typename A::Fragment front;
    A::insertFragment(buffer_, fragment, 0, front);  // distances are exact
    leave(front);
  }

  PixelResult flush() {
    for (int i = 0; i < K; ++i) {
      const typename A::Fragment nearest = A::takeNearest(buffer_);
      leave(nearest);
    }
    return result_;
  }

 private:
  void leave(const typename A::Fragment& front) {
    const typename A::Segment segment = A::leaveBefore(state_, front, buffer_);
    const typename A::Fragment& back = buffer_.entry[0];
    if (!A::isEmpty(front) && !A::isEmpty(back) && state_.inside < -0.5 && segment.length > A::kLateTolerance)
      result_.negative = true;
    if (!segment.visible) return;
    result_.longestSegment = std::max(result_.longestSegment, segment.length);
    if (!color_) return;
    const Rgba c = color_(segment.scalarFront, segment.scalarBack, segment.length);
    Rgba& sum = result_.color;
    const auto under = A::compositeUnder({sum[0], sum[1], sum[2], sum[3]}, {c[0], c[1], c[2], c[3]});
    sum = {under.r, under.g, under.b, under.a};
  }

  const SegmentColor& color_;
  typename A::KBuffer buffer_;
  typename A::PixelState state_{0, 0};
  PixelResult result_;
};

template <int K>
PixelResult replayPixel(const std::vector<ExactFragment>& fragments, const SegmentColor& color) {
  PixelReplay<K> pixel(color);
  for (const ExactFragment& fragment : fragments) pixel.add(fragment);
  return pixel.flush();
}

using ReplayPixel = PixelResult (*)(const std::vector<ExactFragment>&, const SegmentColor&);

template <int... Before>
constexpr std::array<ReplayPixel, sizeof...(Before)> replayTable(std::integer_sequence<int, Before...>) {
  return {replayPixel<Before + 1>...};
}
constexpr auto kReplayPixel = replayTable(std::make_integer_sequence<int, 14>());

/// Sums of one k that several tiles add to.
struct Totals {
  std::atomic<std::size_t> misordered{0}, misorderedPixels{0}, negativePixels{0};
  std::atomic<double> longestSegment{0};

  void add(const PixelResult& pixel) {
    misordered += pixel.misordered;
    misorderedPixels += pixel.misordered > 0 ? 1 : 0;
    negativePixels += pixel.negative ? 1 : 0;
    double longest = longestSegment;
    while (longest < pixel.longestSegment && !longestSegment.compare_exchange_weak(longest, pixel.longestSegment)) {
    }
  }
};

}  // namespace

std::vector<ReplayResult> replay(const ReplayInput& input, std::span<const int> ks, const SegmentColor& color) {
  const View& view = input.view;
  const FragmentSource source(input.points, *input.faces, input.order, input.scalars, view);
  std::vector<ReplayResult> results(ks.size());
  for (std::size_t i = 0; i < ks.size(); ++i) {
    if (ks[i] < 1 || ks[i] > static_cast<int>(kReplayPixel.size())) throw std::invalid_argument("k must be in 1 .. 14");
    if (color) results[i].image.resize(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
  }
  std::vector<Totals> totals(ks.size());
  std::atomic<std::size_t> fragmentCount{0}, unbalancedPixels{0};

  parallelBlocks(0, source.tileCount(), 1, [&](std::size_t firstTile, std::size_t lastTile) {
    std::vector<std::vector<ExactFragment>> pixels;
    for (std::size_t tile = firstTile; tile < lastTile; ++tile) {
      source.collect(tile, pixels);
      for (int p = 0; p < kTileSize * kTileSize; ++p) {
        const auto& fragments = pixels[static_cast<std::size_t>(p)];
        if (fragments.empty()) continue;
        int balance = 0;
        for (const ExactFragment& fragment : fragments) balance += fragment.kind;
        fragmentCount += fragments.size();
        unbalancedPixels += balance != 0 ? 1 : 0;
        const int x = source.firstColumn(tile) + p % kTileSize, y = source.firstRow(tile) + p / kTileSize;
        for (std::size_t i = 0; i < ks.size(); ++i) {
          const PixelResult pixel = kReplayPixel[static_cast<std::size_t>(ks[i] - 1)](fragments, color);
          totals[i].add(pixel);
          if (color) results[i].image[static_cast<std::size_t>(y * view.width + x)] = pixel.color;
        }
      }
    }
  });

  for (std::size_t i = 0; i < ks.size(); ++i) {
    results[i].fragments = fragmentCount;
    results[i].unbalancedPixels = unbalancedPixels;
    results[i].misordered = totals[i].misordered;
    results[i].misorderedPixels = totals[i].misorderedPixels;
    results[i].negativePixels = totals[i].negativePixels;
    results[i].longestSegment = totals[i].longestSegment;
  }
  return results;
}

ReplayResult replay(const ReplayInput& input, int k, const SegmentColor& color) {
  return replay(input, std::array{k}, color).front();
}

ViewPoint viewPoint(const View& view) {
  ViewPoint point;
  point.orthographic = view.orthographic;
  point.eye = view.eye;
  point.direction = view.forward;
  return point;
}

SegmentColor constantExtinction(double extinction) {
  return [=](double, double, double length) {
    const double alpha = -std::expm1(-extinction * length);
    return Rgba{alpha, alpha, alpha, alpha};
  };
}

SegmentColor scalarExtinction(double extinction) {
  return [=](double front, double back, double length) {
    const double scalar = 0.5 * (front + back);
    const double alpha = -std::expm1(-extinction * scalar * length);
    return Rgba{scalar * alpha, scalar * scalar * alpha, alpha, alpha};
  };
}

double greatestDifference(const std::vector<Rgba>& a, const std::vector<Rgba>& b) {
  if (a.size() != b.size()) throw std::invalid_argument("pictures of different sizes");
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t c = 0; c < 4; ++c) most = std::max(most, std::abs(a[i][c] - b[i][c]));
  return most;
}

}  // namespace havs::test
