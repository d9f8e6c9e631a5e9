#pragma once
#include <cstdint>
#include <vector>

namespace havs {

/// How a cell becomes tetrahedra.
enum class CutRule {
  leaveOut,         ///< of lower dimension
  keep,             ///< a tetrahedron already
  fromLowestPoint,  ///< linear and convex: a cone from its lowest point number
  fromCentre,       ///< quadratic: a cone from a point in its middle
  quadraticTetra,   ///< four corners and the octahedron between them
  polyhedron,       ///< a cone from its centre; its faces come with the cell
  unsupported       ///< of a higher order than the second
};

/// What is known of a type of cell, in VTK's numbering of types and of the points in a cell.
struct CellShape {
  const char* name = nullptr;  ///< plural, for messages; null for a number that is no type
  CutRule rule = CutRule::leaveOut;
  std::uint8_t pointCount = 0;  ///< 0: differs from cell to cell
  /// The surface of a solid cell as polygons of its points, turned outward when the cell's Jacobian is positive in
  /// VTK's parametric coordinates. The faces of quadratic cells appear divided at their mid nodes.
  std::vector<std::vector<std::uint8_t>> facets;
  std::int8_t centreNode = -1;  ///< the point in the middle, where the type has one
};

/// The shape of VTK's cell type; `name` is null for a number that is no type.
const CellShape& cellShape(std::uint8_t vtkType);

}  // namespace havs
