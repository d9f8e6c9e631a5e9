#include "render/fragment_values.h"

#include "core/parallel.h"

namespace havs {
namespace {

/// At a normalised scalar.
ColorAndExtinction colorAt(const ExtinctionCurve& curve, double scalar) {
  const ExtinctionCurve::Knot knot = curve.at(scalar);
  const double fraction = curve.maximumKappa > 0 ? knot.kappa / curve.maximumKappa : 0.0;
  return {static_cast<float>(knot.color[0]), static_cast<float>(knot.color[1]), static_cast<float>(knot.color[2]),
          static_cast<float>(fraction)};
}

/// valueOf(cell) for the cells behind each face.
template <class Value, class ValueOf>
std::vector<std::array<Value, 2>> behindFaces(const PreparedScene& prepared, const ValueOf& valueOf) {
  std::vector<std::array<Value, 2>> behind(prepared.faces.size());
  parallelFor(0, behind.size(), kGrain, [&](std::size_t f) {
    const auto [in, out] = prepared.faces.cells[f];
    behind[f] = {valueOf(in), out == kNoIndex ? Value{} : valueOf(out)};
  });
  return behind;
}

}  // namespace

std::vector<std::array<float, 2>> scalarsBehindFaces(const PreparedScene& prepared) {
  return behindFaces<float>(prepared, [&](Index cell) { return static_cast<float>(prepared.scalars[cell]); });
}

std::vector<std::array<ColorAndExtinction, 2>> colorsBehindFaces(const PreparedScene& prepared) {
  return behindFaces<ColorAndExtinction>(prepared,
                                         [&](Index cell) { return colorAt(prepared.curve, prepared.scalars[cell]); });
}

std::vector<ColorAndExtinction> colorsOfPoints(const PreparedScene& prepared) {
  std::vector<ColorAndExtinction> colors(prepared.points.size());
  parallelFor(0, colors.size(), kGrain,
              [&](std::size_t i) { colors[i] = colorAt(prepared.curve, prepared.scalars[i]); });
  return colors;
}

}  // namespace havs
