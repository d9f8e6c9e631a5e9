#pragma once
// The mesh of the benches that take any, a cube by default.
#include <string>

#include "mesh/read.h"
#include "mesh/scalar_field.h"

namespace havs {

/// Reads a mesh, a surface by TetGen with `switches`; the cube gets a smooth field `s`.
inline TetMesh benchMesh(const std::string& file, const std::string& switches) {
  ReadOptions reading;
  reading.tetgenSwitches = switches;
  TetMesh mesh = readMesh(file, reading);
  if (file == HAVS_MESHES "/cube.poly") {
    mesh.pointFields = {fieldFromExpression(mesh, "s", "0.5+0.25*sin(7*x)*cos(5*y)+0.2*sin(6*z+3*x*y)")};
    mesh.cellFields.clear();
  }
  return mesh;
}

}  // namespace havs
