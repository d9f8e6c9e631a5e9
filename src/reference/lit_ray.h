#pragma once
#include <span>
#include <vector>

#include "light/light_data.h"
#include "light/light_plan.h"
#include "reference/cell_segments.h"
#include "reference/ray_color.h"
#include "scene/prepared_scene.h"
#include "scene/view.h"

namespace havs {

/// Rays of one view of a lit scene. Light is found where a ray enters and leaves a cell, from the numbers of the cell's
/// points (LightData), and goes linearly between; so does what the modulation leaves of the extinction. The integral of
/// colour times light times extinction, attenuated, is by Gauss-Legendre quadrature, to the digits of double.
/// Isosurfaces have the light where they are met.
class LitRays {
 public:
  /// All must outlive it. `rows`: LightData::rowsFor. `volume`: whether it shows, or isosurfaces alone.
  LitRays(const PreparedScene& prepared, const LightPlan& plan, const std::vector<float>& rows,
          std::vector<ViewLight> lights, const View& view, bool volume = true);

  /// Of the pixel (x, y), whose segments these are, in order; ends at the first opaque surface. The layers of its ray
  /// are as they are, in no light.
  RayColor color(int x, int y, std::span<const CellSegment> segments, std::span<const RayLayer> onRay = {}) const;

  /// What falls on a point of the ray.
  struct Incident {
    double light = 1;
    double density = 1;
  };

 private:
  Incident incidentAt(const Vec3& place, Index cell, const Vec3& toEye) const;

  const PreparedScene& prepared_;
  const LightPlan& plan_;
  const std::vector<float>& rows_;
  std::vector<ViewLight> lights_;
  const View& view_;
  bool volume_;
};

}  // namespace havs
