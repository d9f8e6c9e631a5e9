#pragma once
#include <string>
#include <vector>

#include "mesh/tet_mesh.h"

namespace havs {

enum class Centering { point, cell };

/// The scalar that is drawn.
struct ScalarField {
  std::string name;  ///< as asked for, or as chosen by default: "density", "velocity:magnitude"
  Centering centering = Centering::point;
  std::vector<double> values;  ///< one a point, or one a cell
  double minimum = 0;          ///< over finite values at points (cells) that are used
  double maximum = 0;
};

/// Length of one tuple of a vector field, safe for values from 1e-300 to 1e300.
double magnitudeAt(const Field& field, std::size_t tuple);

/// `name`: "F", "F:x|y|z|0|1|...|magnitude", optionally after "point:" or "cell:" (a name in both is the point field).
/// A vector without a component gives its magnitude. Empty: first point scalar, else magnitude of the first point
/// vector, else first cell scalar, else magnitude of the first cell vector. Throws Error{input}: no such field (names
/// the nearest and lists all), no such component, no finite value.
ScalarField selectField(const TetMesh& mesh, const std::string& name);

/// A point field from an expression in x, y, z (muparser's syntax), in the mesh's coordinates: "sqrt(x^2+y^2)".
/// Throws Error{input} with muparser's message and position.
Field fieldFromExpression(const TetMesh& mesh, const std::string& name, const std::string& expression);

/// Leaves out the cells where the scalar is not finite (a point of theirs, or the cell's own value): holes.
/// Returns how many; mesh and field are changed together. Throws Error{input} when no cell is left.
std::size_t withoutHoles(TetMesh& mesh, ScalarField& field);

}  // namespace havs
