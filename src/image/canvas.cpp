#include "image/canvas.h"

#include <cairo.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>

#include "core/error.h"

namespace havs {

struct Canvas::Sheet {
  cairo_surface_t* surface;
  cairo_t* cairo;
  Sheet(int width, int height)
      : surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height)), cairo(cairo_create(surface)) {}
  ~Sheet() {
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
  }
  Sheet(const Sheet&) = delete;
  Sheet& operator=(const Sheet&) = delete;

  void color(const Color& c) { cairo_set_source_rgb(cairo, c[0], c[1], c[2]); }

  /// The same shapes on every machine: no hinting, no subpixels.
  void font(double size) {
    cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, size);
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(cairo, options);
    cairo_font_options_destroy(options);
  }

  double advance(const std::string& text) {
    cairo_text_extents_t extents;
    cairo_text_extents(cairo, text.c_str(), &extents);
    return extents.x_advance;
  }
};

namespace {

/// Of the font's size: what capitals and digits take above the baseline, and what letters take below it.
constexpr double kAscent = 0.73, kDescent = 0.24;

/// How far left of the point a text of this width begins.
double toTheLeft(Anchor anchor, double width) {
  return anchor == Anchor::start ? 0 : anchor == Anchor::middle ? width / 2 : width;
}

/// How far below the point the baseline is.
double below(Anchor anchor, double size) {
  return anchor == Anchor::start ? kAscent * size : anchor == Anchor::middle ? kAscent / 2 * size : -kDescent * size;
}

}  // namespace

TextSize measureText(const std::string& text, const TextStyle& style) {
  static thread_local std::unique_ptr<Canvas> canvas;
  if (!canvas) canvas = std::make_unique<Canvas>(1, 1);
  return canvas->measure(text, style);
}

Canvas::Canvas(int width, int height) {
  constexpr int kMost = 32767;  // Cairo's own limit
  if (width <= 0 || height <= 0 || width > kMost || height > kMost)
    failInput("a figure must have between 1 and 32767 pixels a side");
  sheet_ = std::make_unique<Sheet>(width, height);
  if (cairo_status(sheet_->cairo) != CAIRO_STATUS_SUCCESS) throw std::bad_alloc();
}
Canvas::~Canvas() = default;
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;

TextSize Canvas::measure(const std::string& text, const TextStyle& style) {
  sheet_->font(style.size);
  return {sheet_->advance(text), (kAscent + kDescent) * style.size};
}

void Canvas::fillRectangle(double x, double y, double width, double height, const Color& color) {
  sheet_->color(color);
  cairo_rectangle(sheet_->cairo, x, y, width, height);
  cairo_fill(sheet_->cairo);
}

void Canvas::strokeRectangle(double x, double y, double width, double height, const Color& color, double lineWidth) {
  sheet_->color(color);
  cairo_set_line_width(sheet_->cairo, lineWidth);
  cairo_rectangle(sheet_->cairo, x, y, width, height);
  cairo_stroke(sheet_->cairo);
}

void Canvas::fillPolygon(const std::vector<std::array<double, 2>>& corners, const Color& color) {
  sheet_->color(color);
  for (const auto& [x, y] : corners) cairo_line_to(sheet_->cairo, x, y);
  cairo_close_path(sheet_->cairo);
  cairo_fill(sheet_->cairo);
}

void Canvas::line(double x0, double y0, double x1, double y1, const Color& color, double lineWidth) {
  sheet_->color(color);
  cairo_set_line_width(sheet_->cairo, lineWidth);
  cairo_move_to(sheet_->cairo, x0, y0);
  cairo_line_to(sheet_->cairo, x1, y1);
  cairo_stroke(sheet_->cairo);
}

void Canvas::text(double x, double y, const std::string& text, const TextStyle& style) {
  cairo_t* cairo = sheet_->cairo;
  const TextSize size = measure(text, style);
  sheet_->color(style.color);
  cairo_save(cairo);
  cairo_translate(cairo, x, y);
  if (style.turned) cairo_rotate(cairo, -1.57079632679489661923);
  cairo_move_to(cairo, -toTheLeft(style.horizontal, size.width), below(style.vertical, style.size));
  cairo_show_text(cairo, text.c_str());
  cairo_restore(cairo);
}

Image Canvas::image() const {
  cairo_surface_flush(sheet_->surface);
  const int width = cairo_image_surface_get_width(sheet_->surface);
  const int height = cairo_image_surface_get_height(sheet_->surface);
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(sheet_->surface));
  const unsigned char* bytes = cairo_image_surface_get_data(sheet_->surface);
  Image image{width, height,
              std::vector<float>(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::uint32_t argb;
      std::memcpy(&argb, bytes + static_cast<std::size_t>(y) * stride + 4 * static_cast<std::size_t>(x), sizeof argb);
      for (unsigned c = 0; c < 4; ++c)
        image.pixel(x, y)[c] = static_cast<float>((argb >> (c == 3 ? 24 : 16 - 8 * c) & 255u) / 255.0);
    }
  return image;
}

void lay(const Image& what, int x, int y, Image& onto) {
  for (int row = std::max(0, -y); row < std::min(what.height, onto.height - y); ++row)
    for (int column = std::max(0, -x); column < std::min(what.width, onto.width - x); ++column) {
      const float* from = what.pixel(column, row);
      float* to = onto.pixel(x + column, y + row);
      for (std::size_t c = 0; c < 4; ++c) to[c] = from[3] == 1 ? from[c] : from[c] + (1 - from[3]) * to[c];
    }
}

Image plainImage(int width, int height, const Color& color) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  Image image{width, height, std::vector<float>(4 * pixels, 1.0f)};
  for (std::size_t i = 0; i < pixels; ++i)
    for (std::size_t c = 0; c < 3; ++c) image.rgba[4 * i + c] = static_cast<float>(color[c]);
  return image;
}

}  // namespace havs
