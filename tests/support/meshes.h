#pragma once
// Procedural meshes and fields whose geometry the tests know in closed form. All cells are right-handed, nothing is
// welded that the description does not say.
#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/tet_mesh.h"

namespace havs::test {

/// How a hexahedron becomes tetrahedra; both conform across shared faces.
enum class Cut {
  five,  ///< alternating parity
  six    ///< around the diagonal from the lowest to the highest corner
};

/// Grid indices to a point. A grid map must keep every cell right-handed.
using GridMap = std::function<Vec3(int i, int j, int k)>;
/// Whether grid cell (i, j, k) exists.
using GridCells = std::function<bool(int i, int j, int k)>;

/// A grid of nx * ny * nz hexahedra with mapped corners. Corners that no cell uses stay as unreferenced points only if
/// `exists` leaves cells out.
TetMesh gridMesh(int nx, int ny, int nz, Cut cut, const GridMap& map, const GridCells& exists = {});

/// [-1, 1]^3 as n^3 cubes. Inner points are moved by up to `jitter` (below 0.3) cube edges, by the given seed; boundary
/// points stay on the boundary.
TetMesh box(int n, Cut cut = Cut::six, double jitter = 0, std::uint32_t seed = 1);
/// The unit ball, from the box by a radial map.
TetMesh ball(int n);
/// [-1, 0] x [-1, 1]^2 and [gap, 1 + gap] x [-1, 1]^2, not welded: with gap 0 they touch in two layers of points at the
/// same place.
TetMesh twoBoxes(int n, double gap);
/// A cubic shell between half edges 0.6 and 1, and in its hollow a box of half edge 0.3: rays enter and leave up to
/// three times.
TetMesh nestedShells(int n);
/// An annulus 0.4 <= r <= 1 about z, |z| <= 0.5, whose points at angle 0 and 2 pi are two sets of bit-identical
/// positions.
TetMesh oGrid(int radial, int around, int axial);
/// [-1, 1]^3 with a square hole |x|, |y| < 1/3 through along z; n must be a multiple of 3.
TetMesh boxWithHole(int n);
/// [-1, 1]^3 with layers that thin out geometrically towards y = -1 by `ratio` each, and bend with x: cells of high
/// aspect ratio.
TetMesh stretchedLayers(int n, double ratio);
/// The corner tetrahedron of the unit cube.
TetMesh singleTetrahedron();
/// Three bricks around the z axis, each twisted about it so that, seen along z, each lies partly in front of the next,
/// round and round.
TetMesh visibilityCycle();
/// Both meshes in one, nothing welded.
TetMesh merged(TetMesh a, const TetMesh& b);

/// Point values of f.
std::vector<double> pointValues(const std::vector<Vec3>& points, const std::function<double(const Vec3&)>& f);
std::vector<double> constantField(const std::vector<Vec3>& points, double value);
/// 0.5 + dot(gradient, p).
std::vector<double> linearField(const std::vector<Vec3>& points, const Vec3& gradient);
/// A smooth field in [0, 1] for points of the unit ball.
std::vector<double> smoothField(const std::vector<Vec3>& points);

double volume(const TetMesh& mesh, std::size_t cell);

}  // namespace havs::test
