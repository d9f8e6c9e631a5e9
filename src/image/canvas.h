#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "image/image.h"

namespace havs {

/// Where a text stands against the point it is drawn at.
enum class Anchor { start, middle, end };

struct TextStyle {
  double size = 13;  ///< of the font, in pixels
  Color color{0, 0, 0};
  Anchor horizontal = Anchor::start;
  Anchor vertical = Anchor::middle;  ///< start: the point is above the text; middle: of capitals and digits
  bool turned = false;               ///< reads upwards: turned about the point by 90 degrees counter-clockwise
};

/// Pixels that a text takes, before it is turned.
struct TextSize {
  double width = 0;
  double height = 0;
};
TextSize measureText(const std::string& text, const TextStyle& style = {});

/// A transparent sheet to draw lines and text on, smoothed (Cairo; the font is DejaVu Sans where it is installed).
/// Coordinates are pixels, x right, y down, (0, 0) the upper left corner of the upper left pixel.
class Canvas {
 public:
  /// Throws std::bad_alloc; Error{input} for a size that is not positive or beyond 32767.
  Canvas(int width, int height);
  ~Canvas();
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;

  void fillRectangle(double x, double y, double width, double height, const Color& color);
  /// `lineWidth` in pixels, half of it inside.
  void strokeRectangle(double x, double y, double width, double height, const Color& color, double lineWidth = 1);
  void fillPolygon(const std::vector<std::array<double, 2>>& corners, const Color& color);
  void line(double x0, double y0, double x1, double y1, const Color& color, double lineWidth = 1);
  /// UTF-8.
  void text(double x, double y, const std::string& text, const TextStyle& style = {});

  /// What text() would take.
  TextSize measure(const std::string& text, const TextStyle& style = {});

  /// What was drawn, in steps of 1/255.
  Image image() const;

 private:
  struct Sheet;
  std::unique_ptr<Sheet> sheet_;
};

/// Lays `what` over `onto`, its upper left pixel at (x, y); what falls outside is left away. Where `what` is opaque its
/// values are taken over bit for bit.
void lay(const Image& what, int x, int y, Image& onto);

/// A picture of one opaque colour.
Image plainImage(int width, int height, const Color& color);

}  // namespace havs
