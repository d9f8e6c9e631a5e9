#pragma once
// A scene in memory, drawn by the native device as often as a test likes, each time by a plan changed a little.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "image/compare.h"
#include "render/plan.h"
#include "scene/prepared_scene.h"
#include "scene/renderer.h"

namespace havs::test {

using PlanChange = std::function<void(RenderPlan&)>;

class NativeScene {
 public:
  NativeScene(Scene scene, TetMesh mesh);

  havs::Drawing draw(const PlanChange& change = {}) const;
  Image truth() const;
  /// What draw() gives against truth(), every pixel: no mask.
  Comparison againstTruth() const;
  /// The same camera and data, other settings.
  havs::Drawing drawAs(const Scene& scene, const PlanChange& change = {}) const;

  Scene scene;
  PreparedScene prepared;
  View view;
};

/// A mesh with a point field of smoothField (support/meshes.h).
TetMesh withSmoothPoints(TetMesh mesh);
/// The same field, one value a cell.
TetMesh withSmoothCells(TetMesh mesh);

/// Nothing where all numbers are the same, to the last bit; else how many pixels are not, and by how much.
std::string differenceInBits(const Image& a, const Image& b);
/// Of certificates, counts and sums, too.
std::string differenceInBits(const havs::Drawing& a, const havs::Drawing& b);

}  // namespace havs::test
