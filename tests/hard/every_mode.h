#pragma once
// Every mode on both devices against its reference.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "hard/hard_case.h"
#include "reference/edge_mask.h"
#include "render/devices.h"
#include "render/make_renderer.h"
#include "render/modes.h"

namespace havs::test {

/// Whether all numbers are finite and of [0, 1]. Emission has light without opacity, so this asks for less than
/// notAPicture.
inline bool isFinitePicture(const Image& image) {
  constexpr float kRounding = 1e-6f;
  return std::all_of(image.rgba.begin(), image.rgba.end(),
                     [](float value) { return std::isfinite(value) && value >= 0 && value <= 1 + kRounding; });
}

/// Errors of the channels that `mask` leaves, ascending.
inline std::vector<double> channelErrors(const Image& a, const Image& b, const std::vector<unsigned char>& mask = {}) {
  std::vector<double> errors;
  for (std::size_t c = 0; c < a.rgba.size(); ++c)
    if (mask.empty() || mask[c / 4] == 0) errors.push_back(std::abs(double{a.rgba[c]} - double{b.rgba[c]}));
  std::sort(errors.begin(), errors.end());
  return errors;
}

class EveryModeTest : public HardPictureTest {
 protected:
  /// Draws in every mode; `surface`: of the mode of isosurfaces, which is left out without one.
  void expectEveryMode(Scene scene, const TetMesh& mesh, std::optional<double> surface) {
    scene.certificate = false;
    scene.width = scene.height = 32;
    for (const Mode& row : modes()) {
      if (!row.seesVolume && !surface) continue;
      SCOPED_TRACE(row.name);
      scene.mode = row.name;
      scene.isosurfaces.clear();
      if (!row.seesVolume) scene.isosurfaces.push_back({*surface, Color{0.2, 0.7, 0.4}, 0.6});
      const HardPicture picture(scene, mesh);
      EXPECT_TRUE(isFinitePicture(picture.truth)) << "the reference";
      expectMode(picture);
    }
  }

 private:
  /// Colours of one scalar that is off by 2^-24, and sums of some tens of segments.
  static constexpr double kNativeMost = 5e-5;
  /// What tests/image/modes_test.cpp grants OpenGL: the rasteriser's grid inside the mesh, float on faces seen edge on.
  static constexpr double kGlP999 = 5e-3;

  void expectMode(const HardPicture& picture) {
    const HardWay native{"native", "native", kNativeDevice, "kbuffer", "topological", 6};
    const HardWay gl{"OpenGL", "k-buffer", "osmesa", "kbuffer", "topological", 6};
    for (const HardWay& way : {native, gl}) {
      SCOPED_TRACE(way.name);
      const Image image = drawIn(way, picture.scene, picture.prepared, picture.view).image;
      EXPECT_TRUE(isFinitePicture(image));
      const bool masked = way.device != kNativeDevice;
      const auto mask = masked ? boundaryEdgeMask(picture.prepared.points, picture.prepared.faces, picture.view)
                               : std::vector<unsigned char>{};
      const auto errors = channelErrors(image, picture.truth, mask);
      if (!masked) expectAtMost("modes, native max", errors.back(), kNativeMost);
      if (masked && !errors.empty())
        expectAtMost("modes, OpenGL p999", errors[errors.size() - 1 - errors.size() / 1000], kGlP999);
    }
  }
};

}  // namespace havs::test
