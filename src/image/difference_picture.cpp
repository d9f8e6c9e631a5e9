#include "image/difference_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "image/canvas.h"
#include "image/color_bar.h"
#include "image/compare.h"

namespace havs {
namespace {

constexpr int kLeastHeight = 220;  // of the figure, for the bar and its title
constexpr int kGap = 12;           // between the picture and the bar, and at the right border
constexpr double kLeastError = 1e-7;

/// One a pixel; -1 where the mask is set.
std::vector<float> errorsOf(const Image& picture, const Image& truth, std::span<const unsigned char> mask,
                            const DifferenceStyle& style) {
  const std::size_t first = style.channel.value_or(0);
  const std::size_t last = style.channel ? *style.channel + 1 : style.channels;
  std::vector<float> errors(truth.rgba.size() / 4, -1.0f);
  parallelFor(0, errors.size(), 4096, [&](std::size_t i) {
    if (!mask.empty() && mask[i]) return;
    float error = 0;
    for (std::size_t c = first; c < last; ++c)
      error = std::max(error, std::abs(picture.rgba[4 * i + c] - truth.rgba[4 * i + c]));
    errors[i] = error;
  });
  return errors;
}

Axis axisFor(double greatest, const DifferenceStyle& style) {
  const double top = style.max.value_or(greatest > 0 ? greatest : 1.0);
  if (!(top > 0) || !std::isfinite(top)) failInput(fmt::format("no scale of errors ends at {}", top));
  return {style.logarithmic ? std::min(kLeastError, 1e-3 * top) : 0.0, top, style.logarithmic};
}

/// The scale's colours at many equal steps: two neighbours are nearer than 8 bits can tell.
class ColorSteps {
 public:
  explicit ColorSteps(const ColorScale& scale) : axis_(scale.axis), colors_(kSteps + 1) {
    for (std::size_t i = 0; i <= kSteps; ++i) {
      const Color color = scale.atPosition(static_cast<double>(i) / kSteps);
      colors_[i] = {static_cast<float>(color[0]), static_cast<float>(color[1]), static_cast<float>(color[2]), 1.0f};
    }
  }
  const std::array<float, 4>& at(double value) const {
    return colors_[static_cast<std::size_t>(std::lround(kSteps * std::clamp(axis_.position(value), 0.0, 1.0)))];
  }

 private:
  static constexpr std::size_t kSteps = 4096;
  Axis axis_;
  std::vector<std::array<float, 4>> colors_;
};

void colorErrors(const std::vector<float>& errors, const ColorScale& scale, const Color& masked, Image& figure,
                 int width) {
  const ColorSteps steps(scale);
  const std::array<float, 4> left{static_cast<float>(masked[0]), static_cast<float>(masked[1]),
                                  static_cast<float>(masked[2]), 1.0f};
  parallelFor(0, errors.size(), 4096, [&](std::size_t i) {
    const int x = static_cast<int>(i % static_cast<std::size_t>(width));
    const int y = static_cast<int>(i / static_cast<std::size_t>(width));
    const auto& color = errors[i] < 0 ? left : steps.at(errors[i]);
    std::copy(color.begin(), color.end(), figure.pixel(x, y));
  });
}

std::string titleOf(const DifferenceStyle& style) {
  const std::string what =
      style.channel ? fmt::format("error in {}", kChannelNames[*style.channel]) : "error of the worst channel";
  return what + (style.logarithmic ? ", logarithmic" : ", linear");
}

/// What stands below the bar.
struct Legend {
  double greatest;
  std::size_t masked;
  Color maskedColor;
};
constexpr double kFontSize = 13;
constexpr int kLineHeight = 20;

std::string greatestText(const Legend& legend) { return "max " + numberLabel(legend.greatest); }
std::string maskedText(const Legend& legend) { return fmt::format("{} masked", legend.masked); }

int legendHeight(const Legend& legend) { return kLineHeight * (legend.masked > 0 ? 2 : 1); }

int legendWidth(const Legend& legend) {
  const double masked = legend.masked > 0 ? kLineHeight + measureText(maskedText(legend)).width : 0;
  return static_cast<int>(std::ceil(std::max(masked, measureText(greatestText(legend)).width)));
}

Image drawLegend(const Legend& legend) {
  Canvas canvas(legendWidth(legend) + 1, legendHeight(legend));
  const TextStyle style{.size = kFontSize};
  canvas.text(0, 0.5 * kLineHeight, greatestText(legend), style);
  if (legend.masked > 0) {
    canvas.fillRectangle(0, kLineHeight + 4, 12, 12, legend.maskedColor);
    canvas.text(kLineHeight, 1.5 * kLineHeight, maskedText(legend), style);
  }
  return canvas.image();
}

void requireStyle(const DifferenceStyle& style) {
  if (style.colors.empty()) failInput("a difference picture needs colours");
  if (style.channels > 4 || style.channel.value_or(0) > 3) failInput("a picture has four channels at most");
}

}  // namespace

DifferencePicture differencePicture(const Image& picture, const Image& truth, std::span<const unsigned char> mask,
                                    const DifferenceStyle& style) {
  requireStyle(style);
  requireSameSize(picture, truth, mask);
  const std::vector<float> errors = errorsOf(picture, truth, mask, style);
  const double greatest = std::max(0.0f, *std::max_element(errors.begin(), errors.end()));
  const ColorScale scale{axisFor(greatest, style), style.colors};
  const ColorBar bar{.scale = scale,
                     .title = titleOf(style),
                     .beyondLow = style.logarithmic,
                     .beyondHigh = greatest > scale.axis.high,
                     .fontSize = kFontSize};
  const Legend legend{greatest, static_cast<std::size_t>(std::count(errors.begin(), errors.end(), -1.0f)),
                      style.masked};

  const int height = std::max(truth.height, kLeastHeight);
  const int left = truth.width + kGap;
  const int width = left + std::max(colorBarWidth(bar), legendWidth(legend)) + kGap;
  DifferencePicture result{plainImage(width, height, {1, 1, 1}), scale};
  colorErrors(errors, scale, style.masked, result.image, truth.width);
  const int below = legendHeight(legend) + 4;
  lay(drawColorBar(bar, height - below), left, 0, result.image);
  lay(drawLegend(legend), left, height - below, result.image);
  return result;
}

}  // namespace havs
