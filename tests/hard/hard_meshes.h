#pragma once
// Meshes that only hard cases need. As in support/meshes.h all cells are right-handed and nothing is welded unless the
// description says otherwise.
#include <array>
#include <cstdint>

#include "support/meshes.h"

namespace havs::test {

/// The box `low` to `high` as n^3 grid cells of five tetrahedra.
TetMesh boxFromTo(const Vec3& low, const Vec3& high, int n);

/// Both meshes in one as merged() does, with the data of the fields that both have in the same places of their lists.
TetMesh mergedWithData(TetMesh a, const TetMesh& b);

/// A cell becomes four about a new point: `shares` of its corners, which add up to 1. The point's data are
/// interpolated, so point data stay the same everywhere; the new cells inherit the cell's data.
void splitCell(TetMesh& mesh, std::size_t cell, const std::array<double, 4>& shares);

/// [-1, 1]^3 as n^3 grid cells (n a multiple of 4) of five tetrahedra, and in its middle, across z, a layer of slivers:
/// each a square's four corners, which lie alternately `thickness` / 2 above and below the middle. Welded.
TetMesh sliverLayer(int n, double thickness);

/// A grid from 0 to the sum of its edges, n cells each way, whose edges grow from `least` to 1 geometrically.
TetMesh gradedGrid(int n, double least);

/// [-1, 1]^3 of n^3 grid cells with layers along y that grow geometrically from the wall y = -1 on: the last is `ratio`
/// times the width of a cell's thinnest layer.
TetMesh boundaryLayers(int n, double ratio);

/// The unit ball's 20 * 4^subdivisions triangles of an icosahedron's subdivision, each a cell with the centre: all
/// cells share that point.
TetMesh cellsAroundPoint(int subdivisions);
/// `count` cells around the edge from (0, 0, -1) to (0, 0, 1), their other edges on the unit circle.
TetMesh cellsAroundEdge(int count);

/// `count` cells, none of which touches another: of random shapes, one a place of a grid in [-1, 1]^3.
TetMesh separateCells(int count, std::uint32_t seed);

/// `depth` cubic shells, one in the other, and gaps as thick as they are between them; the innermost is a box.
TetMesh shellsInShells(int depth);
/// Half edges of these, from outside to inside: matter between the first and the second, the third and the fourth, ...
std::vector<double> shellEdges(int depth);

/// `count` long cells in a ring about z, none touching another: seen from +z each lies over the tail of the next.
TetMesh ringOfSticks(int count);
/// `count` grid cells of six tetrahedra in a closed ring about z, welded; their common faces are twisted so that, seen
/// from +z, each grid cell lies partly over the next.
TetMesh ringOfBricks(int count);

}  // namespace havs::test
