#include "scene/overlays.h"

#include <fmt/format.h>

#include "core/error.h"

namespace havs {
namespace {

void checkColor(const Color& color, const char* option) {
  for (const double channel : color)
    if (!(channel >= 0 && channel <= 1))
      failInput(fmt::format("{} is no share of a colour", channel), option, "colours have three numbers from 0 to 1");
}

void checkWidth(double width, const char* option) {
  if (!(width > 0 && width <= kWidestLine))
    failInput(fmt::format("a line cannot be {} pixels wide", width), option,
              fmt::format("widths lie above 0, up to {}", kWidestLine));
}

void checkOpacity(double opacity, const char* option) {
  if (!(opacity > 0 && opacity <= 1))
    failInput(fmt::format("the opacity is {}", opacity), option, "it must lie above 0, up to 1");
}

}  // namespace

void checkOutline(const Outline& outline) {
  checkColor(outline.color, "--outline");
  checkWidth(outline.width, "--outline");
}

void checkSurface(const BoundarySurface& surface) {
  checkColor(surface.color, "--surface");
  checkOpacity(surface.opacity, "--surface");
}

void checkWireFrame(const WireFrame& wireFrame) {
  checkColor(wireFrame.color, "--wireframe");
  checkWidth(wireFrame.width, "--wireframe");
  checkOpacity(wireFrame.opacity, "--wireframe");
  if (const auto angle = wireFrame.featureAngle; angle && !(*angle >= 0 && *angle <= 180))
    failInput(fmt::format("an angle of {} degrees is none between faces", *angle), "--wireframe",
              "it must lie between 0 and 180");
}

}  // namespace havs
