#include "overlay/line_coverage.h"

#include <algorithm>
#include <cmath>

namespace havs {
namespace {

/// The point of the edge at the least distance before the eye, where it starts nearer.
ScreenPoint clipped(const ScreenPoint& p, const ScreenPoint& other) {
  if (p.w >= kNearestToEye) return p;
  const double share = (kNearestToEye - p.w) / (other.w - p.w);
  const auto between = [share](double from, double to) { return from + share * (to - from); };
  return {between(p.x, other.x), between(p.y, other.y), kNearestToEye, between(p.depth, other.depth)};
}

}  // namespace

double PictureLine::distance(double x, double y) const {
  const double alongX = toX - fromX, alongY = toY - fromY;
  const double squared = alongX * alongX + alongY * alongY;
  const double share =
      squared > 0 ? std::clamp(((x - fromX) * alongX + (y - fromY) * alongY) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(x - (fromX + share * alongX), y - (fromY + share * alongY));
}

std::optional<PictureLine> lineBetween(const ScreenPoint& a, const ScreenPoint& b) {
  if (a.w < kNearestToEye && b.w < kNearestToEye) return std::nullopt;
  const ScreenPoint from = clipped(a, b), to = clipped(b, a);
  return PictureLine{from.x / from.w, from.y / from.w, to.x / to.w, to.y / to.w};
}

double lineCoverage(double distance, double width) {
  return std::max(0.0, std::min(width / 2, distance + 0.5) - std::max(-width / 2, distance - 0.5));
}

PixelSpan pixelsNear(const PictureLine& line, int row, double reach, int width) {
  constexpr PixelSpan kNone{0, -1};
  const double low = row + 0.5 - reach, high = row + 0.5 + reach;
  double begin = 0, end = 1;  // shares of the line that lie between the two
  const double down = line.toY - line.fromY;
  if (down != 0) {
    const double one = (low - line.fromY) / down, other = (high - line.fromY) / down;
    begin = std::max(begin, std::min(one, other));
    end = std::min(end, std::max(one, other));
  } else if (line.fromY < low || line.fromY > high) {
    return kNone;
  }
  if (begin > end) return kNone;
  const double x = line.fromX + begin * (line.toX - line.fromX), other = line.fromX + end * (line.toX - line.fromX);
  const double first = std::floor(std::min(x, other) - reach - 0.5), last = std::ceil(std::max(x, other) + reach - 0.5);
  if (!(last >= 0 && first < width)) return kNone;
  return {static_cast<int>(std::max(first, 0.0)), static_cast<int>(std::min(last, width - 1.0))};
}

}  // namespace havs
