// The built-in transfer functions, one row each. Opacities are per unit length, 1/20 of the mesh's diagonal unless said
// otherwise.
#include <vector>

#include "core/find_row.h"
#include "transfer/color_space.h"
#include "transfer/transfer_function.h"

namespace havs {
namespace {

RgbColor hex(unsigned rgb) { return {(rgb >> 16 & 255) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0}; }

/// Colours at equal steps from 0 to 1.
std::vector<ControlPoint> evenly(const std::vector<unsigned>& colors) {
  std::vector<ControlPoint> points;
  const double last = static_cast<double>(colors.size() - 1);
  for (std::size_t i = 0; i < colors.size(); ++i) points.push_back({static_cast<double>(i) / last, hex(colors[i]), 0});
  return points;
}

/// Opacity from `low` at scalar 0 to `high` at 1.
TransferFunction ramp(const std::string& name, std::vector<ControlPoint> points, double low, double high) {
  for (ControlPoint& p : points) p.opacity = low * (1 - p.scalar) + high * p.scalar;
  return {.name = name, .points = std::move(points)};
}

struct Peak {
  double center;
  double width;  // from one foot to the other
  unsigned color;
  double opacity;
};

/// Triangles of opacity, each of one colour, on clear ground; they do not overlap.
TransferFunction peaks(const std::string& name, const std::vector<Peak>& list) {
  TransferFunction function{.name = name};
  for (const Peak& p : list) {
    const RgbColor color = hex(p.color);
    function.points.push_back({p.center - p.width / 2, color, 0});
    function.points.push_back({p.center, color, p.opacity});
    function.points.push_back({p.center + p.width / 2, color, 0});
  }
  return function;
}

/// Both ends stand out, the middle stays thin.
TransferFunction coolWarm() {
  TransferFunction function{.name = "cool-warm"};
  function.points =
      resampleToRgb(ColorSpace::diverging, {{0, {0.230, 0.299, 0.754}, 0}, {1, {0.706, 0.016, 0.150}, 0}});
  for (ControlPoint& p : function.points)
    p.opacity = 0.02 + 0.23 * (p.scalar < 0.5 ? 1 - 2 * p.scalar : 2 * p.scalar - 1);
  return function;
}

/// The exercise of a course on pre-integration: pink to yellow to white, clear, opaque from 128 to 192, clear again, of
/// 8-bit scalars.
TransferFunction plateauOpaque() {
  return {.name = "plateau-opaque",
          .points = {{64 / 255.0, {1, 0.384313, 0.384313}, 0},
                     {128 / 255.0, {1, 1, 0.705882}, 1},
                     {192 / 255.0, {1, 1, 1}, 1},
                     {1, {1, 1, 1}, 0}}};
}

std::vector<TransferPreset> makePresets() {
  const auto row = [](const std::string& description, TransferFunction function) {
    return TransferPreset{function.name, description, std::move(function)};
  };
  return {
      row("blue to red by way of green, denser towards red",
          ramp("rainbow", evenly({0x0000ff, 0x00ffff, 0x00ff00, 0xffff00, 0xff0000}), 0.01, 0.3)),
      row("blue to red through white (Moreland 2009), both ends dense", coolWarm()),
      row("viridis, even to the eye, denser towards yellow",
          ramp("viridis",
               evenly({0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e, 0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b,
                       0xfde725}),
               0.01, 0.3)),
      row("black to white, denser towards white", ramp("grayscale", evenly({0x000000, 0xffffff}), 0, 0.25)),
      row("inferno, even to the eye, denser towards yellow",
          ramp("inferno",
               evenly({0x000003, 0x1b0c42, 0x4b0c6b, 0x781c6d, 0xa52c60, 0xcf4446, 0xed6825, 0xfb9a06, 0xf7d03c,
                       0xfcfea4}),
               0.005, 0.35)),
      row("three narrow peaks of opacity, blue, green and red: hard for every lookup that samples",
          peaks("three-peaks", {{0.25, 0.04, 0x2166ac, 0.6}, {0.5, 0.04, 0x1b9e50, 0.6}, {0.75, 0.04, 0xd6301d, 0.6}})),
      row("five thin shells like isosurfaces, violet to orange", peaks("shells", {{0.1, 0.02, 0x5e3c99, 0.35},
                                                                                  {0.3, 0.02, 0x3288bd, 0.45},
                                                                                  {0.5, 0.02, 0x66c2a5, 0.55},
                                                                                  {0.7, 0.02, 0xfdc830, 0.7},
                                                                                  {0.9, 0.02, 0xe6550d, 0.85}})),
      row("an opaque plateau between two ramps: two isosurfaces in haze", plateauOpaque()),
  };
}

}  // namespace

std::span<const TransferPreset> transferPresets() {
  static const std::vector<TransferPreset> kPresets = makePresets();
  return kPresets;
}

std::vector<RgbColor> presetColors(const std::string& name, std::size_t count) {
  const TransferFunction& function = findRow(transferPresets(), name, "preset").function;
  std::vector<RgbColor> colors(count);
  for (std::size_t i = 0; i < count; ++i)
    colors[i] = evaluate(function, static_cast<double>(i) / static_cast<double>(count - 1)).color;
  return colors;
}

}  // namespace havs
