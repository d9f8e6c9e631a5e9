#pragma once
#include <span>
#include <string>
#include <vector>

#include "mesh/faces.h"
#include "mesh/local_frame.h"
#include "support/replay.h"

namespace havs::test {

/// A mesh with all that its order and its replay need.
struct OrderedScene {
  TetMesh mesh;
  Faces faces;
  LocalFrame frame;
  std::vector<Vec3> points;     ///< local
  std::vector<double> scalars;  ///< one a point; the smooth field unless set

  explicit OrderedScene(TetMesh m);
  FaceOrder order(const std::string& sort, const View& view) const;
  /// Replays the named order.
  ReplayResult replay(const std::string& sort, const View& view, int k, const SegmentColor& color = {}) const;
  /// The same for each of `ks`, without pictures.
  std::vector<ReplayResult> replay(const std::string& sort, const View& view, std::span<const int> ks) const;
};

}  // namespace havs::test
