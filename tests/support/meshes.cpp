#include "support/meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace havs::test {
namespace {

using Corners = std::array<Index, 8>;  ///< corner x + 2 y + 4 z

void addCell(TetMesh& mesh, Index a, Index b, Index c, Index d) { mesh.tetrahedra.push_back({a, b, c, d}); }

/// One corner tetrahedron at each of four corners of one parity, and the one that is left in the middle.
void cutInFive(TetMesh& mesh, const Corners& q, bool odd) {
  if (!odd) {
    addCell(mesh, q[0], q[1], q[2], q[4]);
    addCell(mesh, q[3], q[2], q[1], q[7]);
    addCell(mesh, q[5], q[4], q[7], q[1]);
    addCell(mesh, q[6], q[7], q[4], q[2]);
    addCell(mesh, q[1], q[2], q[4], q[7]);
  } else {
    addCell(mesh, q[1], q[3], q[0], q[5]);
    addCell(mesh, q[2], q[0], q[3], q[6]);
    addCell(mesh, q[4], q[6], q[5], q[0]);
    addCell(mesh, q[7], q[5], q[6], q[3]);
    addCell(mesh, q[0], q[5], q[3], q[6]);
  }
}

/// One tetrahedron for each path along edges from corner 0 to corner 7.
void cutInSix(TetMesh& mesh, const Corners& q) {
  addCell(mesh, q[0], q[1], q[3], q[7]);
  addCell(mesh, q[0], q[3], q[2], q[7]);
  addCell(mesh, q[0], q[2], q[6], q[7]);
  addCell(mesh, q[0], q[6], q[4], q[7]);
  addCell(mesh, q[0], q[4], q[5], q[7]);
  addCell(mesh, q[0], q[5], q[1], q[7]);
}

GridMap evenGrid(int n, double low, double high) {
  return [=](int i, int j, int k) {
    auto at = [&](int m) { return low + (high - low) * m / n; };
    return Vec3(at(i), at(j), at(k));
  };
}

}  // namespace

TetMesh gridMesh(int nx, int ny, int nz, Cut cut, const GridMap& map, const GridCells& exists) {
  TetMesh mesh;
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) mesh.points.push_back(map(i, j, k));
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        if (exists && !exists(i, j, k)) continue;
        Corners corners;
        for (int c = 0; c < 8; ++c)
          corners[static_cast<std::size_t>(c)] =
              static_cast<Index>((i + (c & 1)) + (nx + 1) * ((j + (c >> 1 & 1)) + (ny + 1) * (k + (c >> 2))));
        if (cut == Cut::five) {
          cutInFive(mesh, corners, (i + j + k) % 2 != 0);
        } else {
          cutInSix(mesh, corners);
        }
        ++mesh.sourceCells;
      }
  return mesh;
}

TetMesh box(int n, Cut cut, double jitter, std::uint32_t seed) {
  std::mt19937 random(seed);
  auto offset = [&](int m) {
    const double value = (random() / 4294967295.0 * 2 - 1) * jitter * 2 / n;
    return m == 0 || m == n ? 0.0 : value;
  };
  const GridMap even = evenGrid(n, -1, 1);
  return gridMesh(n, n, n, cut, [&](int i, int j, int k) {
    const double x = offset(i), y = offset(j), z = offset(k);
    return even(i, j, k) + Vec3(x, y, z);
  });
}

TetMesh ball(int n) {
  TetMesh mesh = box(n, Cut::six);
  for (Vec3& p : mesh.points) {
    const double cube = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    if (cube > 0) p *= cube / length(p);
  }
  for (Tetrahedron& cell : mesh.tetrahedra) {
    const Vec3& a = mesh.points[cell[0]];
    if (dot(cross(mesh.points[cell[1]] - a, mesh.points[cell[2]] - a), mesh.points[cell[3]] - a) < 0)
      std::swap(cell[0], cell[1]);
  }
  return mesh;
}

TetMesh merged(TetMesh a, const TetMesh& b) {
  const auto base = static_cast<Index>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const Tetrahedron& t : b.tetrahedra) addCell(a, t[0] + base, t[1] + base, t[2] + base, t[3] + base);
  a.sourceCells += b.sourceCells;
  return a;
}

TetMesh twoBoxes(int n, double gap) {
  auto halfBox = [&](double low) {
    return gridMesh(n, 2 * n, 2 * n, Cut::six, [=](int i, int j, int k) {
      return Vec3(low + double(i) / n, -1 + double(j) / n, -1 + double(k) / n);
    });
  };
  return merged(halfBox(-1), halfBox(gap));
}

TetMesh nestedShells(int n) {
  const int m = 5 * n;  // cells of 0.4 / n: the hollow of half edge 0.6 ends between cells
  const TetMesh shell = gridMesh(m, m, m, Cut::six, evenGrid(m, -1, 1), [&](int i, int j, int k) {
    auto hollow = [&](int c) { return c >= n && c < m - n; };
    return !(hollow(i) && hollow(j) && hollow(k));
  });
  return merged(shell, gridMesh(n, n, n, Cut::five, evenGrid(n, -0.3, 0.3)));
}

TetMesh oGrid(int radial, int around, int axial) {
  return gridMesh(radial, around, axial, Cut::six, [=](int i, int j, int k) {
    const double r = 0.4 + 0.6 * i / radial;
    const double angle = 2 * std::acos(-1.0) * (j % around) / around;
    return Vec3(r * std::cos(angle), r * std::sin(angle), -0.5 + double(k) / axial);
  });
}

TetMesh boxWithHole(int n) {
  return gridMesh(n, n, n, Cut::six, evenGrid(n, -1, 1), [=](int i, int j, int) {
    auto middle = [&](int c) { return 3 * c >= n && 3 * c < 2 * n; };
    return !(middle(i) && middle(j));
  });
}

TetMesh stretchedLayers(int n, double ratio) {
  const double whole = std::pow(ratio, n) - 1;
  return gridMesh(n, n, n, Cut::six, [=](int i, int j, int k) {
    const double x = -1 + 2.0 * i / n, z = -1 + 2.0 * k / n;
    const double height = (std::pow(ratio, j) - 1) / whole;  // 0 at the wall, 1 at the far side
    return Vec3(x, -1 + 2 * height + 0.3 * std::sin(3 * x) * (1 - height), z);
  });
}

TetMesh singleTetrahedron() {
  TetMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  addCell(mesh, 0, 1, 2, 3);
  mesh.sourceCells = 1;
  return mesh;
}

TetMesh visibilityCycle() {
  constexpr int kBricks = 3;
  const double turn = 2 * std::acos(-1.0) / kBricks;
  // The brick from angle j to j + 1 has its upper end turned on by a fifth of a brick.
  TetMesh mesh = gridMesh(1, kBricks, 1, Cut::six, [&](int i, int j, int k) {
    const double r = 0.3 + 0.7 * i;
    const double angle = turn * ((j % kBricks) + 0.2 * k);
    return Vec3(r * std::cos(angle), r * std::sin(angle), -0.5 + k);
  });
  // Weld angle 2 pi to angle 0, so that the ring is closed.
  for (Tetrahedron& cell : mesh.tetrahedra)
    for (Index& v : cell)
      for (Index w = 0; w < v; ++w)
        if (mesh.points[w] == mesh.points[v]) v = w;
  return mesh;
}

std::vector<double> pointValues(const std::vector<Vec3>& points, const std::function<double(const Vec3&)>& f) {
  std::vector<double> values(points.size());
  std::transform(points.begin(), points.end(), values.begin(), f);
  return values;
}

std::vector<double> constantField(const std::vector<Vec3>& points, double value) {
  return std::vector<double>(points.size(), value);
}

std::vector<double> linearField(const std::vector<Vec3>& points, const Vec3& gradient) {
  return pointValues(points, [&](const Vec3& p) { return 0.5 + dot(gradient, p); });
}

std::vector<double> smoothField(const std::vector<Vec3>& points) {
  return pointValues(points, [](const Vec3& p) {
    return 0.5 + 0.5 * std::sin(2.1 * p.x + 0.3) * std::cos(1.7 * p.y - 0.2) * std::sin(2.6 * p.z + 1.1);
  });
}

double volume(const TetMesh& mesh, std::size_t cell) {
  const Tetrahedron& t = mesh.tetrahedra[cell];
  const Vec3& a = mesh.points[t[0]];
  return dot(cross(mesh.points[t[1]] - a, mesh.points[t[2]] - a), mesh.points[t[3]] - a) / 6;
}

}  // namespace havs::test
