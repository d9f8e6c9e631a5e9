#include "hard/random_meshes.h"

#include <algorithm>
#include <limits>

#include "support/meshes.h"

namespace havs::test {
namespace {

bool allRightHanded(const TetMesh& mesh) {
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i)
    if (!(volume(mesh, i) > 0)) return false;
  return !mesh.tetrahedra.empty();
}

void makeRightHanded(TetMesh& mesh) {
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i)
    if (volume(mesh, i) < 0) std::swap(mesh.tetrahedra[i][0], mesh.tetrahedra[i][1]);
}

void transform(TetMesh& mesh, const std::function<Vec3(const Vec3&)>& map) {
  for (Vec3& p : mesh.points) p = map(p);
}

/// A grid of up to 3 x 3 x 3 hexahedra; points moved, up to a quarter of an edge, as far as no cell turns over.
TetMesh grid(Dice& dice) {
  const int nx = dice.whole(1, 3), ny = dice.whole(1, 3), nz = dice.whole(1, 3);
  const Cut cut = dice.chance(0.5) ? Cut::five : Cut::six;
  const double kept = dice.chance(0.6) ? 1 : dice.between(0.3, 1);
  std::vector<char> exists(static_cast<std::size_t>(nx * ny * nz));
  for (char& e : exists) e = dice.chance(kept);
  exists[0] = 1;
  const TetMesh even = gridMesh(
      nx, ny, nz, cut, [&](int i, int j, int k) { return Vec3(2.0 * i / nx - 1, 2.0 * j / ny - 1, 2.0 * k / nz - 1); },
      [&](int i, int j, int k) { return exists[static_cast<std::size_t>(i + nx * (j + ny * k))] != 0; });
  if (dice.chance(0.35)) return even;
  for (double jitter = dice.between(0.01, 0.25);; jitter /= 2) {
    TetMesh moved = even;
    for (Vec3& p : moved.points) {
      const Vec3 by = dice.inCube(2 * jitter);
      p = p + Vec3(by.x / nx, by.y / ny, by.z / nz);
    }
    if (allRightHanded(moved)) return moved;
  }
}

void keepSomeCells(Dice& dice, TetMesh& mesh) {
  const double kept = dice.between(0.2, 1);
  std::vector<Tetrahedron> cells;
  for (const Tetrahedron& cell : mesh.tetrahedra)
    if (dice.chance(kept)) cells.push_back(cell);
  if (!cells.empty()) mesh.tetrahedra = cells;
}

/// Shares of the corners, adding up to 1, none below `least`.
std::array<double, 4> shares(Dice& dice, double least) {
  std::array<double, 4> share{};
  double sum = 0;
  for (double& s : share) sum += s = least + dice.unit();
  for (double& s : share) s /= sum;
  return share;
}

/// A point inside one cell: four cells of it.
void splitCell(Dice& dice, TetMesh& mesh) {
  const std::size_t which = dice.below(mesh.tetrahedra.size());
  const Tetrahedron cell = mesh.tetrahedra[which];
  const auto share = shares(dice, 0.05);
  Vec3 p(0);
  for (std::size_t i = 0; i < 4; ++i) p += share[i] * mesh.points[cell[i]];
  const auto added = static_cast<Index>(mesh.points.size());
  mesh.points.push_back(p);
  for (std::size_t i = 0; i < 4; ++i) {
    Tetrahedron piece = cell;
    piece[i] = added;
    if (i == 0)
      mesh.tetrahedra[which] = piece;
    else
      mesh.tetrahedra.push_back(piece);
  }
}

/// A point on one edge: two cells of every cell that has the edge.
void splitEdge(Dice& dice, TetMesh& mesh) {
  const Tetrahedron& one = mesh.tetrahedra[dice.below(mesh.tetrahedra.size())];
  const std::size_t i = dice.below(4);
  const Index a = one[i], b = one[(i + 1 + dice.below(3)) % 4];
  const double at = dice.between(0.1, 0.9);
  const auto added = static_cast<Index>(mesh.points.size());
  mesh.points.push_back((1 - at) * mesh.points[a] + at * mesh.points[b]);
  const std::size_t cells = mesh.tetrahedra.size();
  for (std::size_t c = 0; c < cells; ++c) {
    Tetrahedron& cell = mesh.tetrahedra[c];
    const auto atA = std::find(cell.begin(), cell.end(), a), atB = std::find(cell.begin(), cell.end(), b);
    if (atA == cell.end() || atB == cell.end()) continue;
    Tetrahedron other = cell;
    other[static_cast<std::size_t>(atB - cell.begin())] = added;
    *atA = added;
    mesh.tetrahedra.push_back(other);
  }
}

TetMesh oneCell(Dice& dice) {
  TetMesh mesh = singleTetrahedron();
  const double flat = dice.chance(0.5) ? 1 : dice.magnitude(1e-7, 1);
  for (Vec3& p : mesh.points) p = dice.inCube(1);
  const Vec3 middle = (mesh.points[0] + mesh.points[1] + mesh.points[2]) / 3.0;
  mesh.points[3] = middle + flat * (mesh.points[3] - middle);
  makeRightHanded(mesh);
  return mesh;
}

TetMesh split(Dice& dice) {
  TetMesh mesh = dice.chance(0.5) ? oneCell(dice) : box(1, dice.chance(0.5) ? Cut::five : Cut::six);
  const int times = dice.whole(1, 40);
  for (int i = 0; i < times && mesh.tetrahedra.size() < 190; ++i)
    dice.chance(0.5) ? splitCell(dice, mesh) : splitEdge(dice, mesh);
  return mesh;
}

/// One tetrahedron in each box of a grid.
TetMesh soup(Dice& dice) {
  const int n = dice.whole(1, 4);
  TetMesh mesh;
  for (int i = 0; i < n * n * n; ++i) {
    if (dice.chance(0.3) && !mesh.tetrahedra.empty()) continue;
    TetMesh cell = oneCell(dice);
    transform(cell, [&](const Vec3& p) { return p * 0.5 + Vec3(i % n, i / n % n, i / n / n); });
    mesh = merged(std::move(mesh), cell);
  }
  return mesh;
}

TetMesh knownShape(Dice& dice) {
  switch (dice.below(7)) {
    case 0:
      return visibilityCycle();
    case 1:
      return twoBoxes(1, dice.chance(0.5) ? 0 : dice.magnitude(1e-8, 0.5));
    case 2:
      return oGrid(1, dice.whole(3, 8), 1);
    case 3:
      return stretchedLayers(dice.whole(1, 3), dice.between(1.2, 4));
    case 4:
      return boxWithHole(3);
    case 5:
      return ball(2);
    default:
      return singleTetrahedron();
  }
}

TetMesh shape(Dice& dice) {
  switch (dice.below(8)) {
    case 0:
      return oneCell(dice);
    case 1:
    case 2:
      return split(dice);
    case 3:
      return soup(dice);
    case 4:
      return knownShape(dice);
    default:
      return grid(dice);
  }
}

/// Another part beyond the greatest x of the first: touching it or a gap away.
TetMesh withAnotherPart(Dice& dice, TetMesh mesh) {
  TetMesh other = dice.chance(0.5) ? mesh : shape(dice);
  double most = -1e300, least = 1e300;
  for (const Vec3& p : mesh.points) most = std::max(most, p.x);
  for (const Vec3& p : other.points) least = std::min(least, p.x);
  const double gap = dice.chance(0.5) ? 0 : dice.magnitude(1e-9, 1);
  transform(other, [&](const Vec3& p) { return p + Vec3(most - least + gap, 0, 0); });
  return merged(std::move(mesh), other);
}

/// Stretched along a direction, turned, scaled, moved: what does not overlap still does not.
void place(Dice& dice, TetMesh& mesh) {
  if (dice.chance(0.25)) {
    const int axis = dice.whole(0, 2);
    const double factor = dice.magnitude(1e-4, 1);
    transform(mesh, [&](Vec3 p) {
      p[axis] *= factor;
      return p;
    });
  }
  if (dice.chance(0.4)) {
    const Vec3 x = dice.direction();
    const Vec3 y = normalize(cross(x, dice.direction())), z = cross(x, y);
    transform(mesh, [&](const Vec3& p) { return p.x * x + p.y * y + p.z * z; });
  }
  if (dice.chance(0.2)) {
    const double scale = dice.magnitude(1e-3, 1e3);
    const Vec3 by = scale * dice.inCube(dice.magnitude(0.1, 1e3));
    transform(mesh, [&](const Vec3& p) { return scale * p + by; });
  }
}

void renumber(Dice& dice, TetMesh& mesh) {
  std::vector<Index> order(mesh.points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Index>(i);
  dice.shuffle(order);
  std::vector<Vec3> points(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) points[order[i]] = mesh.points[i];
  mesh.points = points;
  for (Tetrahedron& cell : mesh.tetrahedra) {
    for (Index& corner : cell) corner = order[corner];
    const std::size_t turn = dice.below(3);  // of three corners: keeps the handedness
    std::rotate(cell.begin(), cell.begin() + static_cast<std::ptrdiff_t>(turn), cell.begin() + 3);
  }
  dice.shuffle(mesh.tetrahedra);
}

}  // namespace

TetMesh randomMesh(Dice& dice) {
  while (true) {
    TetMesh mesh = shape(dice);
    if (dice.chance(0.2)) keepSomeCells(dice, mesh);
    if (dice.chance(0.15) && mesh.tetrahedra.size() < 100) mesh = withAnotherPart(dice, std::move(mesh));
    place(dice, mesh);
    makeRightHanded(mesh);
    if (!allRightHanded(mesh)) continue;  // shrunk to nothing by rounding
    if (dice.chance(0.4)) renumber(dice, mesh);
    mesh.sourceCells = mesh.tetrahedra.size();
    return mesh;
  }
}

TetMesh randomOverlappingMesh(Dice& dice) {
  TetMesh mesh;
  const int cells = dice.whole(2, 40);
  for (int i = 0; i < cells; ++i) mesh = merged(std::move(mesh), oneCell(dice));
  if (dice.chance(0.5))  // on few places, so that faces and edges lie in one another
    transform(mesh, [](const Vec3& p) { return Vec3(std::round(2 * p.x), std::round(2 * p.y), std::round(2 * p.z)); });
  return mesh;
}

void addRandomField(Dice& dice, TetMesh& mesh) {
  const bool ofCells = dice.chance(0.25);
  std::vector<Vec3> places = mesh.points;
  if (ofCells) {
    places.clear();
    for (const Tetrahedron& t : mesh.tetrahedra)
      places.push_back(0.25 * (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]] + mesh.points[t[3]]));
  }
  std::vector<double> values(places.size());
  const std::size_t kind = dice.below(5);
  const Vec3 gradient = dice.direction();
  const int levels = dice.whole(1, 8);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (kind == 0) values[i] = dot(gradient, places[i]);
    if (kind == 1) values[i] = dice.unit();
    if (kind == 2) values[i] = double(dice.whole(0, levels)) / levels;
    if (kind == 3) values[i] = 0.5;
    if (kind == 4) values[i] = dice.chance(0.5) ? dice.unit() : dice.chance(0.5) ? 0 : dice.magnitude(1e-12, 1);
  }
  if (dice.chance(0.2)) {
    const double scale = dice.magnitude(1e-6, 1e6), offset = scale * dice.between(-100, 100);
    for (double& v : values) v = scale * v + offset;
  }
  if (dice.chance(0.1))
    for (std::size_t i = 1; i < values.size(); ++i)
      if (dice.chance(0.1)) values[i] = std::numeric_limits<double>::quiet_NaN();
  auto& fields = ofCells ? mesh.cellFields : mesh.pointFields;
  fields.clear();
  fields.push_back({ofCells ? "region" : "attribute0", 1, std::move(values)});
}

}  // namespace havs::test
