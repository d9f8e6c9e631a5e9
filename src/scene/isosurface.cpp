#include "scene/isosurface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "scene/prepared_scene.h"

namespace havs {
namespace {

constexpr const char* kOption = "--isosurface";

/// Scalars are cut off at the ends of the domain, so no cell tells where a surface beyond them would be; nor where it
/// is at the lower end, which nothing lies below then.
void refuseOutside(const Isosurface& surface, const PreparedScene& prepared) {
  const auto& [low, high] = prepared.curve.domain;
  const bool cutOff = surface.value == low && prepared.field.minimum < low;
  if (surface.value >= low && surface.value <= high && !cutOff) return;
  failInput(
      fmt::format("{:.6g} is no value of '{}' over {:.6g} to {:.6g}", surface.value, prepared.field.name, low, high),
      kOption, "give one in between, or a wider --domain");
}

}  // namespace

void checkIsosurfaces(const Scene& scene) {
  for (const auto& [value, color, opacity] : scene.isosurfaces) {
    if (!std::isfinite(value)) failInput(fmt::format("{} is no value of a field", value), kOption, "give a number");
    if (!(opacity > 0 && opacity <= 1))
      failInput(fmt::format("the opacity {:.6g} of an isosurface is out of range", opacity), kOption,
                "give one above 0, up to 1");
    if (color && !std::all_of(color->begin(), color->end(), [](double c) { return c >= 0 && c <= 1; }))
      failInput("the colour of an isosurface is out of range", kOption, "give numbers from 0 to 1");
  }
}

std::vector<ShownIsosurface> prepareIsosurfaces(const Scene& scene, PreparedScene& prepared) {
  if (scene.isosurfaces.empty()) return {};
  checkIsosurfaces(scene);
  const ScalarField& field = prepared.field;
  if (field.centering == Centering::cell)
    failInput(fmt::format("'{}' belongs to the cells: it jumps between them and has no isosurface", field.name),
              kOption, "choose a field of the points with --field");
  std::vector<ShownIsosurface> shown;
  for (const Isosurface& surface : scene.isosurfaces) {
    refuseOutside(surface, prepared);
    const double scalar = prepared.curve.normalise(surface.value);
    shown.push_back({surface.value, scalar, surface.color.value_or(prepared.curve.at(scalar).color), surface.opacity});
  }
  std::stable_sort(shown.begin(), shown.end(), [](const auto& a, const auto& b) { return a.scalar < b.scalar; });
  const auto& [low, high] = prepared.curve.domain;
  if (field.minimum < low || field.maximum > high)
    prepared.notes.push_back(
        fmt::format("the data reach beyond the domain, {:.6g} to {:.6g}: cells across its ends are cut off there, and "
                    "isosurfaces in them displaced",
                    low, high));
  return shown;
}

}  // namespace havs
