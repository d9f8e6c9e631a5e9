#pragma once
#include <optional>
#include <string>

#include "mesh/local_frame.h"
#include "scene/view.h"

namespace havs {

enum class Projection { perspective, orthographic };

/// What a user says of the camera, in mesh units. Unset parts follow from the mesh: it is looked at from azimuth 30 and
/// elevation 20 degrees, its bounding sphere fitted.
struct Camera {
  Projection projection = Projection::perspective;
  double azimuth = 30;               ///< degrees about +y; 0 looks along -z
  double elevation = 20;             ///< degrees above the xz plane
  double zoom = 1;                   ///< > 1 magnifies
  double fieldOfView = 30;           ///< vertical (the smaller side's, for fitting), degrees
  std::optional<Vec3> eye;           ///< overrides azimuth and elevation
  std::optional<Vec3> target;        ///< default the mesh's centre
  std::optional<Vec3> up;            ///< default +y; another axis when parallel to the view
  std::optional<double> viewHeight;  ///< orthographic: height of the picture in mesh units at zoom 1; default fitted
};

/// "az,el[,zoom]", a JSON object with the names above in snake_case, or a file that holds one. Throws Error{input}: not
/// finite, unknown key (names the nearest), zoom not positive, field of view not in (0, 180), eye equal to target.
Camera parseCamera(const std::string& text, Projection projection);

/// The camera in the local frame for a picture of width x height pixels. Throws Error{input} as parseCamera, and for a
/// perspective eye beyond 1e15 radii of the mesh, a perspective picture wider than 179.99 degrees, and a pixel at the
/// mesh smaller than 1e-12 or larger than 1e6 radii.
View makeView(const Camera& camera, const LocalFrame& frame, int width, int height);

/// The camera that makeView used, all parts set: what reports print and scripts pass back.
std::string describe(const Camera& camera, const LocalFrame& frame, int width, int height);

}  // namespace havs
