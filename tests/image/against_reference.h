#pragma once
// A scene drawn by OpenGL and by the reference, and what to look at when they differ.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "gl/device.h"
#include "image/compare.h"
#include "image/meshes_drawn.h"
#include "scene/prepared_scene.h"
#include "scene/renderer.h"

namespace havs::test {

/// Both drawings of a scene.
struct Pair {
  PreparedScene prepared;
  View view;
  havs::Drawing picture;  // tests/gl/drawing.h has one of its own
  Image truth;
  std::vector<unsigned char> mask;  ///< boundaryEdgeMask
  Comparison comparison;            ///< outside the mask
};

/// One mesh; skips itself where it cannot be had. What was drawn last is written when the test fails.
class AgainstReference : public testing::TestWithParam<MeshDrawn> {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// Draws at the mesh's size by the scene's lookup and table.
  const Pair& draw(Scene scene);
  /// Every pixel beyond `limit` outside the mask must be traced to a cause; at most 300 are.
  void expectEachTraced(double limit) const;

 private:
  std::unique_ptr<Device> device_;
  TetMesh mesh_;
  std::unique_ptr<Pair> last_;
};

/// Pixels outside the mask whose worst channel is off by more than `limit`.
std::vector<std::size_t> pixelsBeyond(double limit, const Pair& pair);

inline std::string nameOfMesh(const testing::TestParamInfo<MeshDrawn>& info) { return info.param.name; }

}  // namespace havs::test
