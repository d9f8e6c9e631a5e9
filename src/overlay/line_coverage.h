#pragma once
#include <optional>

#include "raster/screen_points.h"

namespace havs {

/// A straight line of the picture from one place to another: pixels, x right, y down, pixel centres at halves.
struct PictureLine {
  double fromX, fromY, toX, toY;

  /// Pixels from (x, y) to the nearest point of the line, its ends included.
  double distance(double x, double y) const;
};

/// An edge of the mesh as the picture has it: what of it lies more than kNearestToEye before the eye. Empty where
/// nothing does.
std::optional<PictureLine> lineBetween(const ScreenPoint& a, const ScreenPoint& b);
inline constexpr double kNearestToEye = 1e-6;  ///< local units along the view

/// How much of a pixel is covered by a line `width` pixels wide whose middle passes the pixel's centre at `distance`:
/// of the stretch of one pixel across the line about the centre, the part that lies within the line. Of [0, 1], and at
/// most `width`; 0 from (width + 1) / 2 on.
double lineCoverage(double distance, double width);

/// The pixels of a row, from `first` to `last`, that may lie within `reach` of a line; empty where last < first.
struct PixelSpan {
  int first, last;
};
PixelSpan pixelsNear(const PictureLine& line, int row, double reach, int width);

}  // namespace havs
