// Structural similarity (see ssim.h). The window is separable: for each row of centres, four weighted moments are
// summed down the columns, then along the row. Each row has its own sum, and rows are added in their order, so that the
// result does not depend on the threads.
#include "image/ssim.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/parallel.h"

namespace havs {
namespace {

constexpr int kRadius = 5;
constexpr double kSigma = 1.5;
constexpr double kC1 = 0.01 * 0.01;  // (K1 range)^2
constexpr double kC2 = 0.03 * 0.03;  // (K2 range)^2

/// The window along one axis, around one centre.
struct Taps {
  int centre = 0;
  int first = 0;
  int count = 0;
  std::array<double, 2 * kRadius + 1> weights;
};

Taps tapsAround(int centre, int size) {
  Taps taps{centre, std::max(0, centre - kRadius), 0, {}};
  double sum = 0;
  for (int i = taps.first; i <= std::min(size - 1, centre + kRadius); ++i) {
    const double distance = i - centre;
    const double weight = std::exp(-distance * distance / (2 * kSigma * kSigma));
    taps.weights[static_cast<std::size_t>(taps.count++)] = weight;
    sum += weight;
  }
  for (double& weight : taps.weights) weight /= sum;
  return taps;
}

/// The windows along a side of `size` pixels.
std::vector<Taps> windowsAlong(int size) {
  const int margin = size > 2 * kRadius ? kRadius : 0;
  std::vector<Taps> windows;
  for (int centre = margin; centre < size - margin; ++centre) windows.push_back(tapsAround(centre, size));
  return windows;
}

/// Of each channel: the means of a, b, a^2 + b^2 and a b under a window.
struct Moments {
  std::array<double, 4> a{}, b{}, squares{}, product{};
};

void addColumnMoments(const Image& a, const Image& b, const Taps& rows, std::vector<Moments>& columns) {
  std::fill(columns.begin(), columns.end(), Moments{});
  for (int k = 0; k < rows.count; ++k) {
    const double weight = rows.weights[static_cast<std::size_t>(k)];
    const float* pixelA = a.pixel(0, rows.first + k);
    const float* pixelB = b.pixel(0, rows.first + k);
    for (Moments& m : columns) {
      for (std::size_t c = 0; c < 4; ++c) {
        const double x = pixelA[c], y = pixelB[c];
        m.a[c] += weight * x;
        m.b[c] += weight * y;
        m.squares[c] += weight * (x * x + y * y);
        m.product[c] += weight * (x * y);
      }
      pixelA += 4;
      pixelB += 4;
    }
  }
}

Moments momentsOfWindow(const std::vector<Moments>& columns, const Taps& taps) {
  Moments sum;
  for (int k = 0; k < taps.count; ++k) {
    const double weight = taps.weights[static_cast<std::size_t>(k)];
    const Moments& m = columns[static_cast<std::size_t>(taps.first + k)];
    for (std::size_t c = 0; c < 4; ++c) {
      sum.a[c] += weight * m.a[c];
      sum.b[c] += weight * m.b[c];
      sum.squares[c] += weight * m.squares[c];
      sum.product[c] += weight * m.product[c];
    }
  }
  return sum;
}

/// Equation 13 of the paper; exactly 1 where both pictures are equal, as both factors are then rounded alike.
double similarity(const Moments& m, std::size_t c) {
  const double meanSquares = m.a[c] * m.a[c] + m.b[c] * m.b[c];
  const double meanProduct = m.a[c] * m.b[c];
  const double variances = m.squares[c] - meanSquares;
  const double covariance = m.product[c] - meanProduct;
  return ((2 * meanProduct + kC1) * (2 * covariance + kC2)) / ((meanSquares + kC1) * (variances + kC2));
}

struct RowSum {
  std::array<double, 4> similarity{};
  std::size_t windows = 0;
};

}  // namespace

std::array<double, 4> structuralSimilarity(const Image& a, const Image& b, std::span<const unsigned char> mask) {
  const auto width = static_cast<std::size_t>(a.width);
  const std::vector<Taps> across = windowsAlong(a.width), down = windowsAlong(a.height);
  std::vector<RowSum> rows(down.size());
  parallelBlocks(0, down.size(), 8, [&](std::size_t first, std::size_t last) {
    std::vector<Moments> columns(width);
    for (std::size_t row = first; row < last; ++row) {
      addColumnMoments(a, b, down[row], columns);
      for (const Taps& taps : across) {
        const auto centre = static_cast<std::size_t>(down[row].centre) * width + static_cast<std::size_t>(taps.centre);
        if (!mask.empty() && mask[centre]) continue;
        const Moments moments = momentsOfWindow(columns, taps);
        for (std::size_t c = 0; c < 4; ++c) rows[row].similarity[c] += similarity(moments, c);
        ++rows[row].windows;
      }
    }
  });
  RowSum total;
  for (const RowSum& row : rows) {
    for (std::size_t c = 0; c < 4; ++c) total.similarity[c] += row.similarity[c];
    total.windows += row.windows;
  }
  if (total.windows == 0) total.similarity.fill(std::numeric_limits<double>::quiet_NaN());
  for (double& value : total.similarity) value /= static_cast<double>(std::max<std::size_t>(1, total.windows));
  return total.similarity;
}

}  // namespace havs
