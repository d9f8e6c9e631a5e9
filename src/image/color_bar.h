#pragma once
#include <string>

#include "image/color_scale.h"
#include "image/image.h"

namespace havs {

/// A colour bar, upright: the colours of a scale, ticks with labels to its right, and the title beside them, turned.
struct ColorBar {
  ColorScale scale;
  std::string title;        ///< UTF-8; what the numbers are, their unit, how the scale runs
  bool beyondLow = false;   ///< values below the scale occur: the lower end is pointed
  bool beyondHigh = false;  ///< values above the scale occur: the upper end is pointed
  double fontSize = 13;     ///< pixels
  Color ink{0, 0, 0};       ///< of text and lines
};

/// Pixels that drawColorBar takes from left to right.
int colorBarWidth(const ColorBar& bar);

/// The bar as a picture of `height` pixels (at least 40), on transparent ground, to lay over a figure of any background
/// (image/canvas.h, lay). Its colours are the scale's, each row that of its centre. Throws Error{input} for a scale
/// without colours or a height that is too small.
Image drawColorBar(const ColorBar& bar, int height);

/// The rows of the bar that show the scale from its high end to its low one: what lies above and below are points, and
/// half the labels at the ends.
struct RowRange {
  int first = 0, last = 0;  ///< inclusive
};
RowRange colorBarRows(const ColorBar& bar, int height);

/// Columns of the bar's colours within drawColorBar.
RowRange colorBarColumns(const ColorBar& bar);

}  // namespace havs
