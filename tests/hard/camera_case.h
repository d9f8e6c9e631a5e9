#pragma once
// What the camera cases share: a mesh whose rays have a closed form, bounds for an eye in the mesh, and the truth held
// to the closed form.
#include <algorithm>
#include <cmath>
#include <limits>

#include "hard/hard_case.h"
#include "reference/reference_renderer.h"
#include "render/make_renderer.h"
#include "scene/eye_cut.h"
#include "support/meshes.h"

namespace havs::test {

/// Extinction, per mesh unit, of the closed forms.
inline constexpr double kConstantKappa = 0.8;
/// The greatest extinction of volumeTransfer().
inline constexpr double kVolumeKappa = 1.3;

/// Of a smooth volume that shows to its far side.
inline std::string volumeTransfer() {
  static const std::string file = transferFile(transferOf({{0, 0.2, 0.4, 0.8, 0.2}, {1, 0.9, 0.5, 0.1, kVolumeKappa}}));
  return file;
}

inline TetMesh withSmoothField(TetMesh mesh) {
  mesh.pointFields = {Field{"s", 1, smoothField(mesh.points)}};
  return mesh;
}

class CameraCase : public HardPictureTest {
 protected:
  using Wide = long double;
  using Wide3 = glm::tvec3<Wide>;

  static Scene cameraScene(const Vec3& eye, const Vec3& target, double fieldOfView = 30, int size = 64) {
    Scene scene = hardScene(size);
    scene.transferFunction = volumeTransfer();
    scene.camera.eye = eye;
    scene.camera.target = target;
    scene.camera.fieldOfView = fieldOfView;
    return scene;
  }

  /// For an eye in the mesh or in its bounding sphere. Before the cut (scene/eye_cut.h) optical depth is missing; and
  /// distances are depths times the length of the ray for one unit of depth, so that a rounding of the depth in float
  /// counts as often: once on the native device, whose functions are relative to the face, with OpenGL at each of the
  /// dozen faces that a ray meets.
  static HardBounds boundsWithin(const Scene& scene, const TetMesh& mesh, double kappa = kVolumeKappa) {
    const LocalFrame frame = localFrame(mesh);
    const View view = makeView(scene.camera, frame, scene.width, scene.height);
    const double depth = kappa * frame.radius, rounding = 0x1p-24 * depth * view.rayScale(0, 0);
    HardBounds bounds;
    bounds.trace = false;
    bounds.native += depth * leftOut(view, kEyeCutInDouble) + rounding;
    bounds.p999 += depth * leftOut(view, kEyeCutInFloat) + 12 * rounding;
    bounds.traced += depth * leftOut(view, kEyeCutInFloat) + 12 * rounding;
    return bounds;
  }

  /// Of rays through [-1, 1]^3 cut into cells, the truth is 1 - exp(-kappa L) with L the way in the box, in front of
  /// the eye. The rays are made anew, from the camera's own numbers, in long double.
  void expectClosedForm(const Scene& asked, const TetMesh& boxMesh, double bound = 1e-7) {
    Scene scene = asked;
    scene.transferFunction = transferFile(
        transferOf({{0, 0.8, 0.4, 0.2, kConstantKappa}, {1, 0.8, 0.4, 0.2, kConstantKappa}}, "extinction"));
    StageTimes stages;
    const PreparedScene prepared = prepareScene(scene, boxMesh, stages);
    const View view = makeView(scene.camera, prepared.frame, scene.width, scene.height);
    const Image truth = makeReference(scene, prepared)->draw(view, stages).image;
    double most = 0;
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x) {
        const double alpha = -std::expm1(-kConstantKappa * wayInBox(scene.camera, prepared.frame, view, x, y));
        const double color[4] = {0.8 * alpha, 0.4 * alpha, 0.2 * alpha, alpha};
        for (int c = 0; c < 4; ++c) {
          const double error = std::abs(
              double{truth.rgba[4 * static_cast<std::size_t>(y * view.width + x) + static_cast<std::size_t>(c)]} -
              color[c]);
          if (!(error <= most)) most = error;
        }
      }
    expectAtMost("reference, off the closed form", most, bound);
  }

 private:
  /// Of the ray of a pixel's centre, relative to the target: far eyes lose nothing.
  static double wayInBox(const Camera& camera, const LocalFrame& frame, const View& view, int x, int y) {
    // Rays along a side count as moved a little to the right and, far less, down (raster/edge_function.h).
    constexpr Wide kRight = 1e-10L, kDown = 1e-13L;
    const Wide u = (2 * (x + 0.5L + kRight) / view.width - 1) * view.halfWidth;
    const Wide v = (1 - 2 * (y + 0.5L + kDown) / view.height) * view.halfHeight;
    const Wide3 across = u * Wide3(view.right) + v * Wide3(view.up);
    const Wide3 target(camera.target.value_or(frame.center)), eye = frame.center + frame.radius * view.eye;
    const Wide distance = camera.eye ? length(target - Wide3(*camera.eye)) : length(target - eye);
    const bool parallel = view.orthographic;
    const Wide3 start = target + (parallel ? Wide{frame.radius} : distance) * across;
    const Wide3 along = Wide3(view.forward) + (parallel ? Wide3(0) : across);
    Wide first = parallel ? -std::numeric_limits<Wide>::infinity() : -distance;
    Wide last = std::numeric_limits<Wide>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      if (along[axis] == 0) {
        if (std::abs(start[axis]) > 1) return 0;
        continue;
      }
      const Wide one = (-1 - start[axis]) / along[axis], other = (1 - start[axis]) / along[axis];
      first = std::max(first, std::min(one, other));
      last = std::min(last, std::max(one, other));
    }
    return static_cast<double>(std::max(Wide{0}, last - first) * length(along));
  }
};

}  // namespace havs::test
