#pragma once
// Random small meshes with a random field.
#include "hard/random_dice.h"
#include "mesh/tet_mesh.h"

namespace havs::test {

/// One to some 200 cells that do not overlap, all of positive volume: grids (jittered, with holes, with cells or single
/// tetrahedra left out), cells split again and again, slivers, parts apart or touching, the shapes of
/// support/meshes.h; sheared, turned, moved and scaled; points and cells in any order.
TetMesh randomMesh(Dice& dice);

/// Tetrahedra anywhere: what is in two of them is drawn in some way, finite.
TetMesh randomOverlappingMesh(Dice& dice);

/// Gives a mesh one scalar field, of the points or of the cells: linear, of few levels, constant, any numbers; some
/// with values that are not numbers.
void addRandomField(Dice& dice, TetMesh& mesh);

}  // namespace havs::test
