#include "transfer/color_space.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>

#include "transfer/interpolate.h"

namespace havs {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr RgbColor kWhiteD65{0.9505, 1.0, 1.089};
constexpr double kRgbTolerance = 1.0 / 1024;
constexpr int kDeepestHalving = 10;

RgbColor mix(const RgbColor& a, const RgbColor& b, double t) { return Shares(0, 1, t).mix(a, b); }

// IEC 61966-2-1 (sRGB) and CIE 15 (CIELAB).
double toLinear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }
double fromLinear(double c) { return c <= 0.0031308 ? c * 12.92 : 1.055 * std::pow(c, 1 / 2.4) - 0.055; }
double labCurve(double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; }
double labCurveInverse(double t) { return t > 6.0 / 29 ? t * t * t : (116 * t - 16) * 27 / 24389; }

RgbColor labFromRgb(const RgbColor& rgb) {
  const double r = toLinear(rgb[0]), g = toLinear(rgb[1]), b = toLinear(rgb[2]);
  const double x = labCurve((0.4124 * r + 0.3576 * g + 0.1805 * b) / kWhiteD65[0]);
  const double y = labCurve((0.2126 * r + 0.7152 * g + 0.0722 * b) / kWhiteD65[1]);
  const double z = labCurve((0.0193 * r + 0.1192 * g + 0.9505 * b) / kWhiteD65[2]);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

RgbColor rgbFromLab(const RgbColor& lab) {
  const double fy = (lab[0] + 16) / 116;
  const double x = kWhiteD65[0] * labCurveInverse(fy + lab[1] / 500);
  const double y = kWhiteD65[1] * labCurveInverse(fy);
  const double z = kWhiteD65[2] * labCurveInverse(fy - lab[2] / 200);
  return {fromLinear(3.2406 * x - 1.5372 * y - 0.4986 * z), fromLinear(-0.9689 * x + 1.8758 * y + 0.0415 * z),
          fromLinear(0.0557 * x - 0.2040 * y + 1.0570 * z)};
}

/// Hue, saturation, value, each 0 to 1.
RgbColor hsvFromRgb(const RgbColor& rgb) {
  const auto [low, high] = std::minmax({rgb[0], rgb[1], rgb[2]});
  const double spread = high - low;
  if (spread == 0) return {0, 0, high};
  double sixth = 0;
  if (high == rgb[0])
    sixth = (rgb[1] - rgb[2]) / spread;
  else if (high == rgb[1])
    sixth = 2 + (rgb[2] - rgb[0]) / spread;
  else
    sixth = 4 + (rgb[0] - rgb[1]) / spread;
  return {sixth < 0 ? sixth / 6 + 1 : sixth / 6, spread / high, high};
}

RgbColor rgbFromHsv(const RgbColor& hsv) {
  RgbColor rgb;
  for (int c = 0; c < 3; ++c) {
    const double phase = std::fmod(hsv[0] * 6 + (c == 0 ? 5 : c == 1 ? 3 : 1) + 6, 6.0);
    rgb[c] = hsv[2] * (1 - hsv[1] * std::clamp(std::min(phase, 4 - phase), 0.0, 1.0));
  }
  return rgb;
}

RgbColor mixHsv(const RgbColor& a, const RgbColor& b, double t, bool wrap) {
  RgbColor from = hsvFromRgb(a), to = hsvFromRgb(b);
  if (wrap && std::abs(from[0] - to[0]) > 0.5) (from[0] > to[0] ? from : to)[0] -= 1;  // the shorter way round
  return rgbFromHsv(mix(from, to, t));
}

/// CIELAB in polar form.
struct Msh {
  double magnitude;
  double saturation;
  double hue;
  bool isGray() const { return saturation < 0.05; }
};

Msh mshFromRgb(const RgbColor& rgb) {
  const RgbColor lab = labFromRgb(rgb);
  const double magnitude = std::hypot(lab[0], lab[1], lab[2]);
  const double saturation = magnitude > 0.001 ? std::acos(std::clamp(lab[0] / magnitude, -1.0, 1.0)) : 0;
  return {magnitude, saturation, saturation > 0.001 ? std::atan2(lab[2], lab[1]) : 0};
}

RgbColor rgbFromMsh(const Msh& c) {
  const double chroma = c.magnitude * std::sin(c.saturation);
  return rgbFromLab({c.magnitude * std::cos(c.saturation), chroma * std::cos(c.hue), chroma * std::sin(c.hue)});
}

/// The hue to give a gray end so that the way to `color` changes evenly to the eye (Moreland 2009, section 5).
double hueOfGray(const Msh& color, double grayMagnitude) {
  if (color.magnitude >= grayMagnitude - 0.1) return color.hue;
  const double spin = color.saturation * std::sqrt(grayMagnitude * grayMagnitude - color.magnitude * color.magnitude) /
                      (color.magnitude * std::sin(color.saturation));
  return color.hue > -0.3 * kPi ? color.hue + spin : color.hue - spin;
}

double hueDifference(double a, double b) { return std::abs(std::remainder(a - b, 2 * kPi)); }

RgbColor mixDiverging(const RgbColor& a, const RgbColor& b, double t) {
  Msh from = mshFromRgb(a), to = mshFromRgb(b);
  if (!from.isGray() && !to.isGray() && hueDifference(from.hue, to.hue) > 0.33 * kPi) {
    const Msh white{std::max({from.magnitude, to.magnitude, 88.0}), 0, 0};
    (t < 0.5 ? to : from) = white;
    t = t < 0.5 ? 2 * t : 2 * t - 1;
  }
  if (from.isGray() && !to.isGray()) from.hue = hueOfGray(to, from.magnitude);
  if (to.isGray() && !from.isGray()) to.hue = hueOfGray(from, to.magnitude);
  if (!from.isGray() && !to.isGray()) to.hue = from.hue + std::remainder(to.hue - from.hue, 2 * kPi);
  return rgbFromMsh({std::lerp(from.magnitude, to.magnitude, t), std::lerp(from.saturation, to.saturation, t),
                     std::lerp(from.hue, to.hue, t)});
}

/// Appends the points strictly between t0 and t1 that RGB needs to follow the curve.
void refine(ColorSpace space, const ControlPoint& a, const ControlPoint& b, double t0, double t1, int level,
            std::vector<ControlPoint>& out) {
  const auto at = [&](double t) { return interpolateColor(space, a.color, b.color, t); };
  const RgbColor first = at(t0), last = at(t1);
  double worst = 0;
  for (double share : {0.25, 0.5, 0.75}) {
    const RgbColor exact = at(std::lerp(t0, t1, share)), straight = mix(first, last, share);
    for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(exact[c] - straight[c]));
  }
  if (level > 0 && (worst <= kRgbTolerance || level == kDeepestHalving)) return;  // level 0: white in the middle
  const double middle = (t0 + t1) / 2;
  refine(space, a, b, t0, middle, level + 1, out);
  out.push_back({std::lerp(a.scalar, b.scalar, middle), at(middle), 0});
  refine(space, a, b, middle, t1, level + 1, out);
}

}  // namespace

std::optional<ColorSpace> colorSpaceNamed(const std::string& name) {
  static const std::map<std::string, ColorSpace> kNames{
      {"rgb", ColorSpace::rgb},  {"hsv", ColorSpace::hsv},    {"hsvnowrap", ColorSpace::hsvNoWrap},
      {"lab", ColorSpace::lab},  {"cielab", ColorSpace::lab}, {"diverging", ColorSpace::diverging},
      {"step", ColorSpace::step}};
  std::string lower;
  for (char c : name) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto found = kNames.find(lower);
  return found == kNames.end() ? std::nullopt : std::optional(found->second);
}

RgbColor interpolateColor(ColorSpace space, const RgbColor& a, const RgbColor& b, double t) {
  RgbColor color = a;
  switch (space) {
    case ColorSpace::rgb:
      color = mix(a, b, t);
      break;
    case ColorSpace::hsv:
      color = mixHsv(a, b, t, true);
      break;
    case ColorSpace::hsvNoWrap:
      color = mixHsv(a, b, t, false);
      break;
    case ColorSpace::lab:
      color = rgbFromLab(mix(labFromRgb(a), labFromRgb(b), t));
      break;
    case ColorSpace::diverging:
      color = mixDiverging(a, b, t);
      break;
    case ColorSpace::step:
      color = b;
      break;
  }
  for (double& c : color) c = std::clamp(c, 0.0, 1.0);
  return color;
}

std::vector<ControlPoint> resampleToRgb(ColorSpace space, const std::vector<ControlPoint>& colors) {
  std::vector<ControlPoint> out;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    if (i > 0 && colors[i].scalar > colors[i - 1].scalar) {
      if (space == ColorSpace::step)
        out.push_back({colors[i - 1].scalar, colors[i].color, 0});
      else if (space != ColorSpace::rgb)
        refine(space, colors[i - 1], colors[i], 0, 1, 0, out);
    }
    out.push_back(colors[i]);
  }
  return out;
}

}  // namespace havs
