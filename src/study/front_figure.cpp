// The fronts on paper, with Cairo: the page's plot (src/study/page/front.js) for where no browser is.
#include "study/front_figure.h"

#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "core/error.h"
#include "core/output_file.h"
#include "study/front_points.h"

namespace havs {
namespace fs = std::filesystem;
namespace {

constexpr double kWidth = 760, kLeft = 78, kRight = 24, kTop = 62, kPlot = 380, kBelow = 56, kLine = 17;
constexpr double kTextSize = 12.5, kPngScale = 2;
constexpr double kMark = 4.5, kSpecialMark = 6.5;  // half the width of a mark

struct Colour {
  double r, g, b;
};
constexpr Colour kInk{.11, .12, .14}, kMuted{.36, .40, .44}, kGrid{.90, .91, .92}, kFront{.04, .36, .68},
    kOther{.62, .66, .70};

struct Box {
  double left, top, width, height;
  bool meets(const Box& o) const {
    return left < o.left + o.width && o.left < left + width && top < o.top + o.height && o.top < top + height;
  }
  bool isWithin(const Box& o) const {
    return left >= o.left && top >= o.top && left + width <= o.left + o.width && top + height <= o.top + o.height;
  }
};

enum class Align { left, middle, right };

/// Cairo's drawing, in the words of this figure.
class Pen {
 public:
  explicit Pen(cairo_surface_t* surface) : cairo_(cairo_create(surface), cairo_destroy) {
    cairo_select_font_face(get(), "sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(get(), kTextSize);
  }
  cairo_t* get() const { return cairo_.get(); }
  void colour(const Colour& c, double opacity = 1) const { cairo_set_source_rgba(get(), c.r, c.g, c.b, opacity); }
  void bold(bool on) const {
    cairo_select_font_face(get(), "sans", CAIRO_FONT_SLANT_NORMAL,
                           on ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  }
  double widthOf(const std::string& text) const {
    cairo_text_extents_t extents;
    cairo_text_extents(get(), text.c_str(), &extents);
    return extents.x_advance;
  }
  void text(double x, double y, const std::string& text, Align align = Align::left) const {
    const double shift = align == Align::left ? 0 : widthOf(text) * (align == Align::middle ? 0.5 : 1);
    cairo_move_to(get(), x - shift, y);
    cairo_show_text(get(), text.c_str());
  }
  void line(double x0, double y0, double x1, double y1, double width) const {
    cairo_set_line_width(get(), width);
    cairo_move_to(get(), x0, y0);
    cairo_line_to(get(), x1, y1);
    cairo_stroke(get());
  }
  void polygon(double x, double y, double size, int corners, double turn) const {
    for (int i = 0; i < corners; ++i) {
      const double angle = turn + 2 * std::numbers::pi * i / corners;
      cairo_line_to(get(), x + size * std::cos(angle), y + size * std::sin(angle));
    }
    cairo_close_path(get());
  }

 private:
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo_;
};

bool isSpecial(const FrontPoint& point) { return point.kind == "paper" || point.kind == "baseline"; }

void drawMark(const Pen& pen, double x, double y, const FrontPoint& point) {
  constexpr double kPi = std::numbers::pi;
  if (point.error == 0)
    pen.polygon(x, y, kMark * 1.4, 3, kPi / 2);
  else if (point.kind == "paper")
    pen.polygon(x, y, kSpecialMark * 1.2, 4, 0);
  else if (point.kind == "baseline")
    pen.polygon(x, y, kSpecialMark * 1.2, 4, kPi / 4);
  else
    cairo_arc(pen.get(), x, y, kMark, 0, 2 * kPi);
  pen.colour(point.onFront ? kFront : kOther, point.onFront || isSpecial(point) ? 1 : 0.5);
  cairo_fill_preserve(pen.get());
  pen.colour(point.onFront || isSpecial(point) ? kInk : kOther);
  cairo_set_line_width(pen.get(), 1);
  cairo_stroke(pen.get());
}

/// One subject's plot, and under it the list of the runs on its front.
class Panel {
 public:
  Panel(const Pen& pen, const FrontPanel& panel, double top)
      : pen_(pen), panel_(panel), area_{kLeft, top + kTop, kWidth - kLeft - kRight, kPlot} {
    std::vector<double> times, errors;
    for (const FrontPoint& point : panel.points) {
      times.push_back(point.time);
      errors.push_back(point.error);
    }
    x_ = logAxis(times);
    y_ = logAxis(errors);
  }

  static double height(const FrontPanel& panel) {
    const auto on =
        std::count_if(panel.points.begin(), panel.points.end(), [](const FrontPoint& p) { return p.onFront; });
    return kTop + kPlot + kBelow + kLine * static_cast<double>(on + 2);
  }

  void draw() {
    drawAxes();
    drawStep();
    for (const FrontPoint& point : panel_.points) drawMark(pen_, xOf(point), yOf(point), point);
    drawNames();
    drawList();
  }

 private:
  double xOf(const FrontPoint& point) const { return area_.left + area_.width * x_.at(point.time); }
  double yOf(const FrontPoint& point) const { return area_.top + area_.height * (1 - y_.at(point.error)); }

  void drawAxes() const {
    pen_.colour(kInk);
    pen_.bold(true);
    pen_.text(kLeft, area_.top - 36, panel_.title);
    pen_.bold(false);
    pen_.text(kLeft, area_.top - 14, "error, 99.9th percentile");
    pen_.text(area_.left + area_.width, area_.top + area_.height + 40, "wall time of a frame, milliseconds",
              Align::right);
    pen_.colour(kMuted);
    pen_.text(area_.left + area_.width, area_.top - 14, "blue: on the front; grey: other runs", Align::right);
    for (const double tick : x_.ticks) {
      const double x = area_.left + area_.width * x_.at(tick);
      pen_.colour(kGrid);
      pen_.line(x, area_.top, x, area_.top + area_.height, 1);
      pen_.colour(kInk);
      pen_.text(x, area_.top + area_.height + 18, tickText(tick), Align::middle);
    }
    for (const double tick : y_.ticks) {
      const double y = area_.top + area_.height * (1 - y_.at(tick));
      pen_.colour(kGrid);
      pen_.line(area_.left, y, area_.left + area_.width, y, 1);
      pen_.colour(kInk);
      pen_.text(area_.left - 8, y + 4, tickText(tick), Align::right);
    }
    pen_.colour(kMuted);
    pen_.line(area_.left, area_.top + area_.height, area_.left + area_.width, area_.top + area_.height, 1);
  }

  void drawStep() const {
    bool begun = false;
    double y = 0;
    for (const FrontPoint& point : panel_.points) {
      if (!point.onFront) continue;
      cairo_line_to(pen_.get(), xOf(point), begun ? y : area_.top);
      y = yOf(point);
      cairo_line_to(pen_.get(), xOf(point), y);
      begun = true;
    }
    if (!begun) return;
    cairo_line_to(pen_.get(), area_.left + area_.width, y);
    pen_.colour(kFront, 0.8);
    cairo_set_line_width(pen_.get(), 1.6);
    cairo_stroke(pen_.get());
  }

  /// Where a name fits beside its mark: the first place that covers no mark and no other name.
  Box placeFor(double width, const FrontPoint& point, const std::vector<Box>& taken) const {
    constexpr double kGap = 8, kHeight = kTextSize;
    const double x = xOf(point), y = yOf(point);
    const std::array<Box, 8> places{{{x + kGap, y - kGap - kHeight, width, kHeight},
                                     {x + kGap + 2, y - kHeight / 2, width, kHeight},
                                     {x - kGap - width, y + kGap, width, kHeight},
                                     {x - width / 2, y - kGap - kHeight, width, kHeight},
                                     {x - kGap - 2 - width, y - kHeight / 2, width, kHeight},
                                     {x - width / 2, y + kGap, width, kHeight},
                                     {x + kGap, y + kGap, width, kHeight},
                                     {x - kGap - width, y - kGap - kHeight, width, kHeight}}};
    for (const Box& place : places)
      if (place.isWithin(area_) &&
          std::none_of(taken.begin(), taken.end(), [&](const Box& b) { return b.meets(place); }))
        return place;
    return places[0].isWithin(area_) ? places[0] : places[7];
  }

  void drawNames() const {
    std::vector<Box> taken;
    for (const FrontPoint& p : panel_.points) taken.push_back({xOf(p) - kMark, yOf(p) - kMark, 2 * kMark, 2 * kMark});
    int number = 0;
    for (const FrontPoint& point : panel_.points) {
      std::string name = point.onFront ? fmt::format("{}", ++number) : "";
      if (isSpecial(point))
        name += (name.empty() ? "" : " ") + std::string(point.kind == "paper" ? "paper" : "default");
      if (name.empty()) continue;
      pen_.bold(true);
      const Box place = placeFor(pen_.widthOf(name), point, taken);
      taken.push_back(place);
      pen_.colour(kInk);
      pen_.text(place.left, place.top + place.height - 2, name);
    }
    pen_.bold(false);
  }

  void drawList() const {
    double y = area_.top + area_.height + kBelow + kLine;
    int number = 0;
    for (const FrontPoint& point : panel_.points) {
      if (!point.onFront) continue;
      pen_.colour(kInk);
      pen_.bold(true);
      pen_.text(kLeft, y, fmt::format("{}", ++number), Align::right);
      pen_.bold(false);
      pen_.text(kLeft + 10, y, point.label);
      pen_.colour(kMuted);
      pen_.text(kWidth - kRight - 90, y, fmt::format("{:.3g} ms", point.time), Align::right);
      pen_.text(kWidth - kRight, y, point.error == 0 ? "0" : fmt::format("{:.2e}", point.error), Align::right);
      y += kLine;
    }
  }

  const Pen& pen_;
  const FrontPanel& panel_;
  Box area_;
  LogAxis x_, y_;
};

double heightOf(const std::vector<FrontPanel>& panels) {
  double height = 0;
  for (const FrontPanel& panel : panels) height += Panel::height(panel);
  return std::max(height, kLine);
}

void drawPanels(cairo_surface_t* surface, const std::vector<FrontPanel>& panels) {
  const Pen pen(surface);
  cairo_set_source_rgb(pen.get(), 1, 1, 1);
  cairo_paint(pen.get());
  double top = 0;
  for (const FrontPanel& panel : panels) {
    Panel(pen, panel, top).draw();
    top += Panel::height(panel);
  }
}

void checkCairo(cairo_status_t status, const fs::path& file) {
  if (status != CAIRO_STATUS_SUCCESS)
    failRunning(fmt::format("writing failed: {}", cairo_status_to_string(status)), file.string(), "is the disk full?");
}

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

void writeSvg(const std::vector<FrontPanel>& panels, const fs::path& file) {
  OutputFile output(file, ErrorKind::running);
  const Surface surface(cairo_svg_surface_create(output.temporary().c_str(), kWidth, heightOf(panels)),
                        cairo_surface_destroy);
  drawPanels(surface.get(), panels);
  cairo_surface_finish(surface.get());
  checkCairo(cairo_surface_status(surface.get()), file);
  output.commit();
}

void writePng(const std::vector<FrontPanel>& panels, const fs::path& file) {
  OutputFile output(file, ErrorKind::running);
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(kPngScale * kWidth),
                                                   static_cast<int>(kPngScale * heightOf(panels))),
                        cairo_surface_destroy);
  cairo_surface_set_device_scale(surface.get(), kPngScale, kPngScale);
  drawPanels(surface.get(), panels);
  checkCairo(cairo_surface_write_to_png(surface.get(), output.temporary().c_str()), file);
  output.commit();
}

}  // namespace

void writeFrontFigures(const nlohmann::json& study, const fs::path& folder) {
  const std::vector<FrontPanel> panels = frontPanels(study);
  writeSvg(panels, folder / "front.svg");
  writePng(panels, folder / "front.png");
}

}  // namespace havs
