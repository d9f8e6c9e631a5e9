#include "render/modes.h"

#include <algorithm>
#include <cmath>

#include "core/find_row.h"
#include "render/gl/renderers.h"
#include "render/native/renderers.h"

namespace havs {
namespace {

constexpr float kNoScalar = -1;      // less than any
constexpr float kBeyondScalars = 2;  // greater than any

void clear(float* pixel) { std::fill_n(pixel, 4, 0.0f); }

void colorOf(const ExtinctionCurve& curve, double scalar, float* pixel) {
  const RayColor color = opaqueColor(curve, scalar);
  for (std::size_t i = 0; i < 4; ++i) pixel[i] = static_cast<float>(color[i]);
}

void finishAbsorption(const ExtinctionCurve&, float* pixel) {
  const double depth = static_cast<double>(pixel[3]);
  clear(pixel);
  pixel[3] = static_cast<float>(-std::expm1(-depth));
}

void finishEmission(const ExtinctionCurve&, float* pixel) {
  for (int i = 0; i < 3; ++i) pixel[i] = std::min(pixel[i], 1.0f);
  pixel[3] = 0;
}

void finishExtreme(const ExtinctionCurve& curve, float* pixel) {
  const float scalar = pixel[0];
  if (scalar == kNoScalar || scalar == kBeyondScalars) return clear(pixel);
  colorOf(curve, static_cast<double>(scalar), pixel);
}

void finishAverage(const ExtinctionCurve& curve, float* pixel) {
  if (!(pixel[1] > 0)) return clear(pixel);
  colorOf(curve, static_cast<double>(pixel[0]) / static_cast<double>(pixel[1]), pixel);
}

const DrawingWay kGl{planGathering, makeGatheringRenderer};
const DrawingWay kNative{planNativeGathering, makeNativeRenderer};

}  // namespace

std::span<const Mode> modes() {
  static const std::vector<Mode> rows{
      {.name = "volume", .description = "emission and absorption, front to back", .reference = rayColor},
      {.name = "isosurfaces",
       .description = "the isosurfaces alone (--isosurface)",
       .measure = {.name = "nothing", .description = "between isosurfaces", .shader = "measure/nothing.glsl"},
       .reference = rayIsosurfaces,
       .seesOpaqueSurfaces = false,
       .seesVolume = false},
      {.name = "xray",
       .description = "absorption only: the background seen through the mesh",
       .gathering = Gathering::sum,
       .measure = {.name = "optical depth",
                   .description = "integral of extinction",
                   .shader = "measure/optical_depth.glsl",
                   .resources = {"curve", "integrals"}},
       .measureOfFewKnots = "measure/optical_depth_by_pieces.glsl",
       .measureOfFewPieces = {.name = "optical depth",
                              .description = "integral of extinction, which few pieces make up",
                              .shader = "measure/optical_depth_of_few_pieces.glsl",
                              .resources = {"few pieces"}},
       .finish = finishAbsorption,
       .reference = rayAbsorption,
       .gl = kGl,
       .native = kNative},
      {.name = "emission",
       .description = "emission only: colour times extinction, summed and added to the background",
       .gathering = Gathering::sum,
       .measure = {.name = "light",
                   .description = "integral of colour times extinction",
                   .shader = "measure/light.glsl",
                   .resources = {"curve", "integrals"}},
       .measureOfFewKnots = "measure/light_by_pieces.glsl",
       .finish = finishEmission,
       .reference = rayEmission,
       .seesOpaqueSurfaces = false,
       .gl = kGl,
       .native = kNative},
      {.name = "maximum",
       .description = "colour of the greatest scalar on the ray (MIP)",
       .gathering = Gathering::greatest,
       .start = {kNoScalar, kNoScalar, kNoScalar, kNoScalar},
       .finish = finishExtreme,
       .reference = rayMaximum,
       .seesClearCells = true,
       .seesOpaqueSurfaces = false,
       .gl = kGl,
       .native = kNative},
      {.name = "minimum",
       .description = "colour of the least scalar on the ray",
       .gathering = Gathering::least,
       .start = {kBeyondScalars, kBeyondScalars, kBeyondScalars, kBeyondScalars},
       .finish = finishExtreme,
       .reference = rayMinimum,
       .seesClearCells = true,
       .seesOpaqueSurfaces = false,
       .gl = kGl,
       .native = kNative},
      {.name = "average",
       .description = "colour of the mean scalar along the ray",
       .gathering = Gathering::sum,
       .measure = {.name = "scalar and length",
                   .description = "integral of the scalar, and the length",
                   .shader = "measure/scalar.glsl"},
       .finish = finishAverage,
       .reference = rayAverage,
       .seesClearCells = true,
       .seesOpaqueSurfaces = false,
       .gl = kGl,
       .native = kNative},
  };
  return rows;
}

const Mode& mode(const std::string& name) { return findRow(modes(), name, "mode"); }

}  // namespace havs
