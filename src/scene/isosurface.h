#pragma once
#include <optional>
#include <vector>

#include "image/image.h"

namespace havs {

struct Scene;
struct PreparedScene;

/// A surface on which the field has one value. Where a ray crosses it, it is composited with the volume before and
/// behind it, once a crossing. A ray from scalar s to s' crosses it where s < value <= s' or s' < value <= s: a value
/// that a face has belongs to one of its two sides, so that the surface there is neither missed nor met twice.
struct Isosurface {
  double value = 0;            ///< in the data's unit
  std::optional<Color> color;  ///< of [0, 1]; empty: the transfer function's at the value
  double opacity = 1;          ///< of (0, 1]; 1: nothing is seen through it
};

/// An isosurface made ready to be drawn.
struct ShownIsosurface {
  double value = 0;   ///< in the data's unit
  double scalar = 0;  ///< normalised to the domain, of [0, 1]
  Color color{};
  double opacity = 1;
};

/// Numbers that are: finite values, colours of [0, 1], opacities of (0, 1]. Throws Error{input}.
void checkIsosurfaces(const Scene& scene);

/// The scene's isosurfaces over the domain and in the colours of `prepared.curve`, ascending by value; of one value, in
/// the scene's order. Throws Error{input} for cell data, which is constant in each cell, and for values outside of the
/// domain. Notes where the data reach beyond the domain, as scalars there are cut off.
std::vector<ShownIsosurface> prepareIsosurfaces(const Scene& scene, PreparedScene& prepared);

}  // namespace havs
