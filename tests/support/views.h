#pragma once
#include "scene/camera.h"

namespace havs::test {

/// Default camera from the given angles in degrees.
inline View viewFrom(const LocalFrame& frame, double azimuth, double elevation, int size,
                     Projection projection = Projection::perspective, double zoom = 1) {
  Camera camera;
  camera.projection = projection;
  camera.azimuth = azimuth;
  camera.elevation = elevation;
  camera.zoom = zoom;
  return makeView(camera, frame, size, size);
}

}  // namespace havs::test
