#include "image/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "image/ssim.h"

namespace havs {
namespace {

double errorOf(const Image& picture, const Image& truth, std::size_t pixel, std::size_t channel) {
  const std::size_t at = 4 * pixel + channel;
  return std::abs(static_cast<double>(picture.rgba[at]) - static_cast<double>(truth.rgba[at]));
}

double worstOf(const Image& picture, const Image& truth, std::size_t pixel, std::size_t channels) {
  double worst = 0;
  for (std::size_t c = 0; c < channels; ++c) worst = std::max(worst, errorOf(picture, truth, pixel, c));
  return worst;
}

std::vector<std::size_t> unmasked(std::size_t pixels, std::span<const unsigned char> mask) {
  std::vector<std::size_t> kept;
  kept.reserve(pixels);
  for (std::size_t i = 0; i < pixels; ++i)
    if (mask.empty() || !mask[i]) kept.push_back(i);
  return kept;
}

/// error(pixel) of each.
template <class Error>
std::vector<double> errorsOf(const std::vector<std::size_t>& pixels, const Error& error) {
  std::vector<double> values(pixels.size());
  parallelFor(0, values.size(), 4096, [&](std::size_t i) { values[i] = error(pixels[i]); });
  return values;
}

/// Blocks of fixed size have their own sums, which are added in their order: the same for any number of threads.
double meanSquare(const std::vector<double>& values) {
  constexpr std::size_t kBlock = 4096;
  std::vector<double> sums((values.size() + kBlock - 1) / kBlock);
  parallelFor(0, sums.size(), 1, [&](std::size_t block) {
    for (std::size_t i = block * kBlock; i < std::min(values.size(), (block + 1) * kBlock); ++i)
      sums[block] += values[i] * values[i];
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0) / static_cast<double>(values.size());
}

/// Leaves the values in another order.
double nearestRank999(std::vector<double>& values) {
  const std::size_t rank = (999 * values.size() + 999) / 1000;  // ceil(0.999 n), 1 .. n
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

void setMeanSquare(double square, ErrorMeasures& measures) {
  measures.rmse = std::sqrt(square);
  measures.psnr = -20 * std::log10(measures.rmse);
}

void setGreatest(std::vector<double>& values, ErrorMeasures& measures) {
  measures.max = *std::max_element(values.begin(), values.end());
  measures.p999 = nearestRank999(values);
}

/// Where the error of the worst channel is greatest.
void findWorst(const Image& picture, const Image& truth, std::size_t pixel, Comparison& comparison) {
  const auto width = static_cast<std::size_t>(truth.width);
  comparison.worstX = static_cast<int>(pixel % width);
  comparison.worstY = static_cast<int>(pixel / width);
  const double worst = worstOf(picture, truth, pixel, comparison.channelCount);
  while (errorOf(picture, truth, pixel, comparison.worstChannel) < worst) ++comparison.worstChannel;
}

void measureErrors(const Image& picture, const Image& truth, const std::vector<std::size_t>& pixels,
                   Comparison& comparison) {
  double squares = 0;
  for (std::size_t c = 0; c < comparison.channelCount; ++c) {
    auto values = errorsOf(pixels, [&](std::size_t pixel) { return errorOf(picture, truth, pixel, c); });
    const double square = meanSquare(values);
    setMeanSquare(square, comparison.channels[c]);
    setGreatest(values, comparison.channels[c]);
    squares += square;
  }
  auto worst =
      errorsOf(pixels, [&](std::size_t pixel) { return worstOf(picture, truth, pixel, comparison.channelCount); });
  const auto greatest = std::max_element(worst.begin(), worst.end()) - worst.begin();
  findWorst(picture, truth, pixels[static_cast<std::size_t>(greatest)], comparison);
  setMeanSquare(squares / static_cast<double>(comparison.channelCount), comparison.rgba);
  setGreatest(worst, comparison.rgba);
}

/// What structural similarity sees of the picture: the truth where the mask is set.
Image withTruthUnderMask(const Image& picture, const Image& truth, std::span<const unsigned char> mask) {
  Image image = picture;
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (mask[i]) std::copy_n(&truth.rgba[4 * i], 4, &image.rgba[4 * i]);
  return image;
}

void measureSimilarity(const Image& picture, const Image& truth, std::span<const unsigned char> mask,
                       Comparison& comparison) {
  const auto ssim = mask.empty() ? structuralSimilarity(picture, truth)
                                 : structuralSimilarity(withTruthUnderMask(picture, truth, mask), truth, mask);
  double sum = 0;
  for (std::size_t c = 0; c < comparison.channelCount; ++c) {
    comparison.channels[c].ssim = ssim[c];
    sum += ssim[c];
  }
  comparison.rgba.ssim = sum / static_cast<double>(comparison.channelCount);
}

}  // namespace

void requireFinite(const Image& image, const std::string& name) {
  const auto bad = std::find_if_not(image.rgba.begin(), image.rgba.end(), [](float v) { return std::isfinite(v); });
  if (bad == image.rgba.end()) return;
  const auto at = static_cast<std::size_t>(bad - image.rgba.begin());
  const auto width = static_cast<std::size_t>(image.width);
  failInput(fmt::format("pixel {},{} has the value {} in {}; only finite numbers can be compared", at / 4 % width,
                        at / 4 / width, *bad, kChannelNames[at % 4]),
            name);
}

void requireSameSize(const Image& picture, const Image& truth, std::span<const unsigned char> mask) {
  if (truth.width <= 0 || truth.height <= 0) failInput("a picture without pixels cannot be compared");
  if (picture.width != truth.width || picture.height != truth.height)
    failInput(fmt::format("the pictures differ in size: {} x {} against {} x {}", picture.width, picture.height,
                          truth.width, truth.height),
              "", "draw both with the same --size");
  if (!mask.empty() && mask.size() != truth.rgba.size() / 4)
    failInput(fmt::format("the mask has {} pixels, the pictures have {}", mask.size(), truth.rgba.size() / 4), "",
              "make it with the same --size");
}

Comparison compareImages(const Image& picture, const Image& truth, std::span<const unsigned char> mask,
                         ImageContent content) {
  requireSameSize(picture, truth, mask);
  requireFinite(picture, "picture");
  requireFinite(truth, "truth");
  Comparison comparison;
  comparison.content = content;
  comparison.channelCount = content == ImageContent::rgba ? 4 : 3;
  const std::vector<std::size_t> pixels = unmasked(truth.rgba.size() / 4, mask);
  comparison.pixels = pixels.size();
  comparison.masked = truth.rgba.size() / 4 - pixels.size();
  if (pixels.empty()) failInput("the mask leaves no pixel to compare");
  measureErrors(picture, truth, pixels, comparison);
  measureSimilarity(picture, truth, mask, comparison);
  return comparison;
}

}  // namespace havs
