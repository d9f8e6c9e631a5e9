#include "hard/hard_meshes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "mesh/defects.h"

namespace havs::test {
namespace {

const double kPi = std::acos(-1.0);

void turnInverted(TetMesh& mesh) {
  for (std::size_t c = 0; c < mesh.tetrahedra.size(); ++c)
    if (volume(mesh, c) < 0) std::swap(mesh.tetrahedra[c][2], mesh.tetrahedra[c][3]);
}

TetMesh welded(TetMesh mesh) {
  weldPoints(mesh);
  return mesh;
}

/// Points that no cell uses go.
TetMesh withoutSparePoints(const TetMesh& mesh) {
  TetMesh result;
  result.sourceCells = mesh.sourceCells;
  std::map<Index, Index> number;
  for (Tetrahedron cell : mesh.tetrahedra) {
    for (Index& v : cell) {
      const auto [place, isNew] = number.try_emplace(v, static_cast<Index>(result.points.size()));
      if (isNew) result.points.push_back(mesh.points[v]);
      v = place->second;
    }
    result.tetrahedra.push_back(cell);
  }
  return result;
}

/// Sums of a geometric row of n parts from `least` on, each `factor` times the one before: n + 1 numbers.
std::vector<double> geometricPlaces(int n, double least, double factor) {
  std::vector<double> places{0};
  for (int i = 0; i < n; ++i) places.push_back(places.back() + least * std::pow(factor, i));
  return places;
}

double at(const std::vector<double>& places, int i) { return places[static_cast<std::size_t>(i)]; }

Vec3 onCircle(double radius, double angle, double z) { return {radius * std::cos(angle), radius * std::sin(angle), z}; }

}  // namespace

TetMesh boxFromTo(const Vec3& low, const Vec3& high, int n) {
  return gridMesh(n, n, n, Cut::five,
                  [&](int i, int j, int k) { return low + (high - low) * Vec3(i, j, k) / static_cast<double>(n); });
}

TetMesh mergedWithData(TetMesh a, const TetMesh& b) {
  TetMesh mesh = merged(std::move(a), b);
  const auto append = [](std::vector<Field>& to, const std::vector<Field>& from) {
    for (std::size_t f = 0; f < to.size(); ++f)
      to[f].values.insert(to[f].values.end(), from[f].values.begin(), from[f].values.end());
  };
  append(mesh.pointFields, b.pointFields);
  append(mesh.cellFields, b.cellFields);
  return mesh;
}

void splitCell(TetMesh& mesh, std::size_t cell, const std::array<double, 4>& shares) {
  const Tetrahedron corners = mesh.tetrahedra[cell];
  Vec3 point(0.0);
  for (std::size_t i = 0; i < 4; ++i) point += shares[i] * mesh.points[corners[i]];
  const auto number = static_cast<Index>(mesh.points.size());
  mesh.points.push_back(point);
  for (Field& field : mesh.pointFields) {
    double value = 0;
    for (std::size_t i = 0; i < 4; ++i) value += shares[i] * field.values[corners[i]];
    field.values.push_back(value);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    Tetrahedron part = corners;
    part[i] = number;
    if (i == 0) {
      mesh.tetrahedra[cell] = part;
      continue;
    }
    mesh.tetrahedra.push_back(part);
    for (Field& field : mesh.cellFields) field.values.push_back(field.values[cell]);
  }
}

TetMesh sliverLayer(int n, double thickness) {
  const double edge = 2.0 / n;
  const auto place = [&](int i, int j, double z) {
    const double off = z != 0 ? 0 : (i + j) % 2 == 0 ? thickness / 2 : -thickness / 2;
    return Vec3(-1 + i * edge, -1 + j * edge, z + off);
  };
  // Of five tetrahedra: the faces at the middle have their diagonals between the lower points below the layer, and,
  // starting with the other parity, between the higher ones above it.
  const TetMesh below =
      gridMesh(n, n, n / 2, Cut::five, [&](int i, int j, int k) { return place(i, j, -1 + k * edge); });
  const TetMesh above = gridMesh(
      n, n, n / 2 + 1, Cut::five, [&](int i, int j, int k) { return place(i, j, (k - 1) * edge); },
      [](int, int, int k) { return k > 0; });
  TetMesh mesh = welded(merged(below, withoutSparePoints(above)));
  std::map<std::array<int, 2>, Index> inLayer;
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
    if (std::abs(mesh.points[p].z) <= thickness)
      inLayer[{static_cast<int>(std::lround((mesh.points[p].x + 1) / edge)),
               static_cast<int>(std::lround((mesh.points[p].y + 1) / edge))}] = static_cast<Index>(p);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      mesh.tetrahedra.push_back(
          {inLayer.at({i, j}), inLayer.at({i + 1, j}), inLayer.at({i, j + 1}), inLayer.at({i + 1, j + 1})});
  turnInverted(mesh);
  return mesh;
}

TetMesh gradedGrid(int n, double least) {
  const std::vector<double> places = geometricPlaces(n, least, std::pow(1 / least, 1.0 / (n - 1)));
  return gridMesh(n, n, n, Cut::six,
                  [&](int i, int j, int k) { return Vec3(at(places, i), at(places, j), at(places, k)); });
}

TetMesh boundaryLayers(int n, double ratio) {
  const double width = 2.0 / n;
  const double thinnest = width / ratio;
  // The factor by which n layers from the thinnest on reach across.
  double low = 1, high = ratio;
  for (int step = 0; step < 200; ++step) {
    const double middle = (low + high) / 2;
    (geometricPlaces(n, thinnest, middle).back() < 2 ? low : high) = middle;
  }
  const std::vector<double> places = geometricPlaces(n, thinnest, low);
  return gridMesh(n, n, n, Cut::six,
                  [&](int i, int j, int k) { return Vec3(-1 + i * width, -1 + at(places, j), -1 + k * width); });
}

TetMesh cellsAroundPoint(int subdivisions) {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  TetMesh mesh;
  mesh.points = {{-1, golden, 0}, {1, golden, 0}, {-1, -golden, 0}, {1, -golden, 0},
                 {0, -1, golden}, {0, 1, golden}, {0, -1, -golden}, {0, 1, -golden},
                 {golden, 0, -1}, {golden, 0, 1}, {-golden, 0, -1}, {-golden, 0, 1}};
  using Triangle = std::array<Index, 3>;
  std::vector<Triangle> triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                     {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                     {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                     {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int step = 0; step < subdivisions; ++step) {
    std::map<std::array<Index, 2>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto [place, isNew] = middles.try_emplace({std::min(a, b), std::max(a, b)}, Index(mesh.points.size()));
      if (isNew) mesh.points.push_back(mesh.points[a] + mesh.points[b]);
      return place->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : triangles) {
      const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
    for (Vec3& p : mesh.points) p = normalize(p);
  }
  const auto centre = static_cast<Index>(mesh.points.size());
  mesh.points.emplace_back(0.0);
  for (const auto& [a, b, c] : triangles) mesh.tetrahedra.push_back({a, b, c, centre});
  mesh.sourceCells = mesh.tetrahedra.size();
  turnInverted(mesh);
  return mesh;
}

TetMesh cellsAroundEdge(int count) {
  TetMesh mesh;
  mesh.points = {{0, 0, -1}, {0, 0, 1}};
  for (int i = 0; i < count; ++i) mesh.points.push_back(onCircle(1, 2 * kPi * i / count, 0));
  for (int i = 0; i < count; ++i)
    mesh.tetrahedra.push_back({0, 1, static_cast<Index>(2 + i), static_cast<Index>(2 + (i + 1) % count)});
  mesh.sourceCells = mesh.tetrahedra.size();
  turnInverted(mesh);
  return mesh;
}

TetMesh separateCells(int count, std::uint32_t seed) {
  const int side = static_cast<int>(std::ceil(std::cbrt(count)));
  const double edge = 2.0 / side;
  std::mt19937 random(seed);
  const auto within = [&](double half) { return (random() / 4294967295.0 * 2 - 1) * half; };
  TetMesh mesh;
  for (int c = 0; c < count; ++c) {
    const Vec3 middle = Vec3(c % side, c / side % side, c / side / side) * edge + Vec3(-1 + edge / 2);
    const auto first = static_cast<Index>(mesh.points.size());
    for (const Vec3 corner : {Vec3(-1, -1, -1), Vec3(1, 1, -1), Vec3(1, -1, 1), Vec3(-1, 1, 1)}) {
      const double x = within(0.12), y = within(0.12), z = within(0.12);
      mesh.points.push_back(middle + edge * (0.3 * corner + Vec3(x, y, z)));
    }
    mesh.tetrahedra.push_back({first, first + 1, first + 2, first + 3});
  }
  mesh.sourceCells = mesh.tetrahedra.size();
  turnInverted(mesh);
  return mesh;
}

std::vector<double> shellEdges(int depth) {
  std::vector<double> edges;
  for (int i = 2 * depth - 1; i > 0; --i) edges.push_back(i / (2.0 * depth - 1));
  return edges;
}

TetMesh shellsInShells(int depth) {
  TetMesh mesh;
  const std::vector<double> edges = shellEdges(depth);
  for (int shell = 0; shell < depth; ++shell) {
    const auto outer = static_cast<std::size_t>(2 * shell);
    if (outer + 1 == edges.size()) return merged(mesh, boxFromTo(Vec3(-edges[outer]), Vec3(edges[outer]), 1));
    const std::array<double, 4> places{-edges[outer], -edges[outer + 1], edges[outer + 1], edges[outer]};
    const auto place = [&](int i) { return places[static_cast<std::size_t>(i)]; };
    mesh = merged(mesh, withoutSparePoints(gridMesh(
                            3, 3, 3, Cut::six, [&](int i, int j, int k) { return Vec3(place(i), place(j), place(k)); },
                            [](int i, int j, int k) { return i != 1 || j != 1 || k != 1; })));
  }
  return mesh;
}

TetMesh ringOfSticks(int count) {
  const double turn = 2 * kPi / count, overhang = 0.35 * turn, width = std::min(0.15, 0.25 * turn), rise = 0.3;
  TetMesh mesh;
  for (int j = 0; j < count; ++j) {
    const double from = j * turn - overhang, to = (j + 1) * turn + overhang;
    const auto addEdge = [&](double angle, double z, double tilt) {
      const Vec3 middle = onCircle(1, angle, z), half = width * (onCircle(1, angle, 0) + Vec3(0, 0, tilt));
      mesh.points.push_back(middle - half);
      mesh.points.push_back(middle + half);
    };
    const auto first = static_cast<Index>(mesh.points.size());
    addEdge(from, -rise, -0.7);
    addEdge(to, rise, 0.7);
    mesh.tetrahedra.push_back({first, first + 1, first + 2, first + 3});
  }
  mesh.sourceCells = mesh.tetrahedra.size();
  turnInverted(mesh);
  return mesh;
}

TetMesh ringOfBricks(int count) {
  const double turn = 2 * kPi / count;
  TetMesh mesh = gridMesh(1, count, 1, Cut::six, [&](int i, int j, int k) {
    return onCircle(0.3 + 0.7 * i, turn * (j % count + 0.2 * k), -0.5 + k);
  });
  return welded(std::move(mesh));
}

}  // namespace havs::test
