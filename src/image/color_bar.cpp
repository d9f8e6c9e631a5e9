#include "image/color_bar.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "image/canvas.h"

namespace havs {
namespace {

constexpr int kLeastHeight = 40;

/// Sizes in pixels, all from the font's.
struct Layout {
  int barWidth, margin, tick, gap, point;
  explicit Layout(const ColorBar& bar)
      : barWidth(static_cast<int>(std::lround(1.4 * bar.fontSize))),
        margin(static_cast<int>(std::lround(0.6 * bar.fontSize))),
        tick(static_cast<int>(std::lround(0.35 * bar.fontSize))),
        gap(static_cast<int>(std::lround(0.3 * bar.fontSize))),
        point(static_cast<int>(std::lround(0.9 * bar.fontSize))) {}
};

TextStyle styleOf(const ColorBar& bar) { return {.size = bar.fontSize, .color = bar.ink}; }

/// As many as stand clear of each other.
std::vector<Tick> ticksFor(const ColorBar& bar, int rows) {
  return ticksOf(bar.scale.axis, std::clamp(static_cast<int>(rows / (2.2 * bar.fontSize)), 2, 8));
}

double widestLabel(const ColorBar& bar) {
  double width = 0;
  for (const int most : {2, 8})
    for (const Tick& tick : ticksOf(bar.scale.axis, most))
      width = std::max(width, measureText(tick.label, styleOf(bar)).width);
  return width;
}

void requireBar(const ColorBar& bar) {
  requireAxis(bar.scale.axis);
  if (bar.scale.colors.empty()) failInput("a colour bar needs colours");
}

Image coloredRows(const ColorBar& bar, int width, int rows) {
  Image image = plainImage(width, rows, {0, 0, 0});
  for (int y = 0; y < rows; ++y) {
    const Color color = bar.scale.atPosition(1 - (y + 0.5) / rows);
    for (int x = 0; x < width; ++x)
      for (std::size_t c = 0; c < 3; ++c) image.pixel(x, y)[c] = static_cast<float>(color[c]);
  }
  return image;
}

void drawEnds(Canvas& canvas, const ColorBar& bar, const Layout& layout, double top, double bottom) {
  const double width = layout.barWidth;
  if (bar.beyondHigh)
    canvas.fillPolygon({{0, top}, {width, top}, {width / 2, top - layout.point}}, bar.scale.atPosition(1));
  if (bar.beyondLow)
    canvas.fillPolygon({{0, bottom}, {width, bottom}, {width / 2, bottom + layout.point}}, bar.scale.atPosition(0));
}

/// Smaller where the bar is shorter than the title.
void drawTitle(Canvas& canvas, const ColorBar& bar, int width, int height) {
  TextStyle title = styleOf(bar);
  title.horizontal = Anchor::middle;
  title.vertical = Anchor::end;
  title.turned = true;
  title.size *= std::min(1.0, (height - 4) / canvas.measure(bar.title, title).width);
  canvas.text(width - 1, height / 2.0, bar.title, title);
}

}  // namespace

RowRange colorBarRows(const ColorBar& bar, int height) {
  const Layout layout(bar);
  return {std::max(layout.margin, bar.beyondHigh ? layout.point : 0),
          height - 1 - std::max(layout.margin, bar.beyondLow ? layout.point : 0)};
}

RowRange colorBarColumns(const ColorBar& bar) { return {0, Layout(bar).barWidth - 1}; }

int colorBarWidth(const ColorBar& bar) {
  requireBar(bar);
  const Layout layout(bar);
  const double title = bar.title.empty() ? 0 : layout.gap + measureText(bar.title, styleOf(bar)).height;
  return static_cast<int>(std::ceil(layout.barWidth + layout.tick + layout.gap + widestLabel(bar) + title)) + 1;
}

Image drawColorBar(const ColorBar& bar, int height) {
  requireBar(bar);
  if (height < kLeastHeight) failInput("a colour bar needs a height of at least 40 pixels");
  const Layout layout(bar);
  const RowRange range = colorBarRows(bar, height);
  const int rows = range.last - range.first + 1;
  const double top = range.first, bottom = range.last + 1;
  const int width = colorBarWidth(bar);

  Canvas canvas(width, height);
  drawEnds(canvas, bar, layout, top, bottom);
  for (const Tick& tick : ticksFor(bar, rows)) {
    const double y = bottom - tick.position * rows;
    const double length = tick.label.empty() ? 0.6 * layout.tick : layout.tick;
    canvas.line(layout.barWidth, y, layout.barWidth + length, y, bar.ink);
    canvas.text(layout.barWidth + layout.tick + layout.gap, y, tick.label, styleOf(bar));
  }
  if (!bar.title.empty()) drawTitle(canvas, bar, width, height);

  Image image = canvas.image();
  lay(coloredRows(bar, layout.barWidth, rows), 0, range.first, image);
  return image;
}

}  // namespace havs
