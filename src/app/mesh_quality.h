#pragma once
#include "mesh/tet_mesh.h"

namespace havs {

struct Range {
  double minimum = 0;
  double maximum = 0;
};

/// Shapes of the cells, in mesh units. Cells with a point that is not finite are left out.
struct MeshQuality {
  std::array<Vec3, 2> bounds{Vec3{0}, Vec3{0}};  ///< least and greatest coordinates of the points that cells use
  Range edgeLength;
  Range volume;       ///< without sign
  Range aspectRatio;  ///< longest edge / (2 sqrt(6) radius of the inscribed sphere): 1 for the regular tetrahedron;
                      ///< without flat cells
  double medianAspectRatio = 0;
};

/// All zero for a mesh without a finite cell.
MeshQuality measureQuality(const TetMesh& mesh);

}  // namespace havs
