#include "render/certificate_picture.h"

#include <algorithm>
#include <cmath>

namespace havs {
namespace {

/// Along the scale, evenly: each lighter than the one before, so that it reads without colours, too.
constexpr std::array<std::array<float, 3>, 5> kScale{{{0.36f, 0.22f, 0.72f},
                                                      {0.71f, 0.21f, 0.48f},
                                                      {0.94f, 0.38f, 0.36f},
                                                      {0.99f, 0.69f, 0.47f},
                                                      {0.99f, 0.99f, 0.75f}}};

std::array<float, 3> colorOf(double place) {
  const double scaled = place * (kScale.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(scaled), kScale.size() - 2);
  const auto part = static_cast<float>(scaled - static_cast<double>(low));
  std::array<float, 3> color{};
  for (std::size_t c = 0; c < 3; ++c) color[c] = kScale[low][c] + part * (kScale[low + 1][c] - kScale[low][c]);
  return color;
}

}  // namespace

std::uint32_t mostMisordered(const Certificate& certificate) {
  return certificate.count.empty() ? 0 : *std::max_element(certificate.count.begin(), certificate.count.end());
}

Image certificatePicture(const Certificate& certificate, int width) {
  const double whole = std::log(std::max(2.0, static_cast<double>(mostMisordered(certificate))));
  Image picture{width, static_cast<int>(certificate.count.size() / static_cast<std::size_t>(width)), {}};
  picture.rgba.reserve(4 * certificate.count.size());
  for (const std::uint32_t count : certificate.count) {
    const auto color =
        count == 0 ? std::array{0.0f, 0.0f, 0.0f} : colorOf(std::log(static_cast<double>(count)) / whole);
    picture.rgba.insert(picture.rgba.end(), {color[0], color[1], color[2], 1.0f});
  }
  return picture;
}

}  // namespace havs
