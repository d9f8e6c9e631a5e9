#pragma once
// Orders of accuracy: errors at several sizes, their slopes, and what is expected of them.
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "hard/every_mode.h"
#include "hard/smooth_rays.h"
#include "support/slope.h"

namespace havs::test {

inline constexpr double kTolerance = 0.2;  ///< of an order: what is left of the next one on meshes of these sizes

inline const HardWay kNative{"native", "native", kNativeDevice, "kbuffer", "topological", 6};
inline const HardWay kOpenGl{"OpenGL", "k-buffer", "osmesa", "kbuffer", "topological", 6};

inline TetMesh withSmooth(TetMesh mesh) {
  mesh.pointFields = {Field{"s", 1, pointValues(mesh.points, smoothScalar)}};
  return mesh;
}

inline Scene smoothScene(int size) {
  Scene scene = hardScene(size);
  static const std::string transfer = smoothTransferFile();
  scene.transferFunction = transfer;
  return scene;
}

/// Tests that measure orders.
class Convergence : public HardPictureTest {
 protected:
  /// Errors by size: prints them, and holds their slopes to `order`. Norms without a bound are printed only.
  struct Orders {
    std::string name;
    double expected = 2;
    bool mean = false, rms = true, most = true;
  };
  void expectOrders(const Orders& orders, const std::vector<double>& sizes, const std::vector<Norms>& norms) {
    const auto slope = [&](double Norms::*norm) {
      std::vector<double> errors;
      for (const Norms& n : norms) errors.push_back(n.*norm);
      return slopeOf(sizes, errors);
    };
    for (std::size_t i = 0; i < sizes.size(); ++i)
      std::cout << fmt::format("{:>20} {:8.4g}: mean {:.3e} rms {:.3e} max {:.3e}\n", orders.name, sizes[i],
                               norms[i].mean, norms[i].rms, norms[i].most);
    std::cout << fmt::format("{:>20} theory {}: slopes {:.3f} {:.3f} {:.3f}\n", orders.name, orders.expected,
                             slope(&Norms::mean), slope(&Norms::rms), slope(&Norms::most));
    const std::string what = orders.name + ", order off " + fmt::format("{:g}", orders.expected) + " in the ";
    if (orders.mean) expectAtMost(what + "mean", std::abs(slope(&Norms::mean) - orders.expected), kTolerance);
    if (orders.rms) expectAtMost(what + "RMS", std::abs(slope(&Norms::rms) - orders.expected), kTolerance);
    if (orders.most) expectAtMost(what + "maximum", std::abs(slope(&Norms::most) - orders.expected), kTolerance);
  }

  /// Errors of the pictures that `draw` makes on meshes of `make`, each compared with what `by` sees.
  std::vector<Norms> errorsOn(const std::vector<int>& meshes, const std::function<TetMesh(int n)>& make,
                              const Scene& scene, const BodyRays& rays, const SeenBy& by,
                              const std::function<Image(const HardPicture&, int n)>& draw) {
    std::vector<Norms> norms;
    for (const int n : meshes) {
      const HardPicture picture(scene, make(n));
      const Image image = draw(picture, n);
      EXPECT_TRUE(isFinitePicture(image));
      norms.push_back(normsOf(image, seen(picture, rays, by)));
    }
    return norms;
  }
};

/// Of the cells of boxes.
inline std::vector<double> widths(const std::vector<int>& meshes) {
  std::vector<double> h;
  for (const int n : meshes) h.push_back(2.0 / n);
  return h;
}

}  // namespace havs::test
