#include "mesh/cell_shapes.h"

#include <array>
#include <utility>

namespace havs {
namespace {

using Polygon = std::vector<std::uint8_t>;
using Facets = std::vector<Polygon>;
using Node = std::uint8_t;

Facets joined(std::initializer_list<Facets> faces) {
  Facets all;
  for (const Facets& face : faces) all.insert(all.end(), face.begin(), face.end());
  return all;
}

// Quadratic faces, divided at their mid nodes: corners in order, then the mid node of each side from its first corner
// on.
Facets triangle6(Node a, Node b, Node c, Node ab, Node bc, Node ca) {
  return {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}};
}
Facets triangle7(Node a, Node b, Node c, Node ab, Node bc, Node ca, Node centre) {
  return {{a, ab, centre}, {ab, b, centre}, {b, bc, centre}, {bc, c, centre}, {c, ca, centre}, {ca, a, centre}};
}
Facets quad8(Node a, Node b, Node c, Node d, Node ab, Node bc, Node cd, Node da) {
  return {{a, ab, da}, {b, bc, ab}, {c, cd, bc}, {d, da, cd}, {ab, bc, cd, da}};
}
Facets quad9(Node a, Node b, Node c, Node d, Node ab, Node bc, Node cd, Node da, Node centre) {
  return {{a, ab, centre, da}, {b, bc, centre, ab}, {c, cd, centre, bc}, {d, da, centre, cd}};
}
/// Mid nodes on two opposite sides only.
Facets quad6(Node a, Node b, Node c, Node d, Node ab, Node cd) { return {{a, ab, cd, d}, {ab, b, c, cd}}; }

/// A prism over a polygon of n corners: 0 .. n-1 below, counterclockwise seen from above, n .. 2n-1 above.
Facets prism(Node n) {
  Polygon bottom, top;
  Facets facets;
  for (Node i = 0; i < n; ++i) {
    const Node next = static_cast<Node>((i + 1) % n);
    bottom.insert(bottom.begin(), i);
    top.push_back(static_cast<Node>(n + i));
    facets.push_back({i, next, static_cast<Node>(n + next), static_cast<Node>(n + i)});
  }
  facets.push_back(bottom);
  facets.push_back(top);
  return facets;
}

Facets hexahedronSides9() {
  return joined({quad9(0, 4, 7, 3, 16, 15, 19, 11, 20), quad9(1, 2, 6, 5, 9, 18, 13, 17, 21),
                 quad9(0, 1, 5, 4, 8, 17, 12, 16, 22), quad9(3, 7, 6, 2, 19, 14, 18, 10, 23)});
}
Facets wedgeEnds6() { return joined({triangle6(0, 2, 1, 8, 7, 6), triangle6(3, 4, 5, 9, 10, 11)}); }

using Table = std::array<CellShape, 256>;

void addSmallCells(Table& t) {
  constexpr std::pair<int, const char*> kSmall[] = {{0, "empty cells"},
                                                    {1, "vertices"},
                                                    {2, "poly-vertices"},
                                                    {3, "lines"},
                                                    {4, "polylines"},
                                                    {5, "triangles"},
                                                    {6, "triangle strips"},
                                                    {7, "polygons"},
                                                    {8, "pixels"},
                                                    {9, "quadrilaterals"},
                                                    {21, "quadratic edges"},
                                                    {22, "quadratic triangles"},
                                                    {23, "quadratic quadrilaterals"},
                                                    {28, "biquadratic quadrilaterals"},
                                                    {30, "quadratic-linear quadrilaterals"},
                                                    {34, "biquadratic triangles"},
                                                    {35, "cubic lines"},
                                                    {36, "quadratic polygons"},
                                                    {51, "parametric curves"},
                                                    {52, "parametric surfaces"},
                                                    {53, "parametric triangles"},
                                                    {54, "parametric quadrilaterals"},
                                                    {60, "higher-order edges"},
                                                    {61, "higher-order triangles"},
                                                    {62, "higher-order quadrilaterals"},
                                                    {63, "higher-order polygons"},
                                                    {68, "Lagrange curves"},
                                                    {69, "Lagrange triangles"},
                                                    {70, "Lagrange quadrilaterals"},
                                                    {75, "Bezier curves"},
                                                    {76, "Bezier triangles"},
                                                    {77, "Bezier quadrilaterals"}};
  for (const auto& [type, name] : kSmall) t[type].name = name;
}

void addLinearCells(Table& t) {
  t[10] = {"tetrahedra", CutRule::keep, 4};
  t[11] = {"voxels",
           CutRule::fromLowestPoint,
           8,
           {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  t[12] = {"hexahedra", CutRule::fromLowestPoint, 8, prism(4)};
  t[13] = {"wedges", CutRule::fromLowestPoint, 6, prism(3)};
  t[14] = {"pyramids", CutRule::fromLowestPoint, 5, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
  t[15] = {"pentagonal prisms", CutRule::fromLowestPoint, 10, prism(5)};
  t[16] = {"hexagonal prisms", CutRule::fromLowestPoint, 12, prism(6)};
  t[42] = {"polyhedra", CutRule::polyhedron, 0};
}

void addQuadraticCells(Table& t) {
  t[24] = {"quadratic tetrahedra", CutRule::quadraticTetra, 10};
  t[25] = {
      "quadratic hexahedra", CutRule::fromCentre, 20,
      joined({quad8(0, 4, 7, 3, 16, 15, 19, 11), quad8(1, 2, 6, 5, 9, 18, 13, 17), quad8(0, 1, 5, 4, 8, 17, 12, 16),
              quad8(3, 7, 6, 2, 19, 14, 18, 10), quad8(0, 3, 2, 1, 11, 10, 9, 8), quad8(4, 5, 6, 7, 12, 13, 14, 15)})};
  t[26] = {"quadratic wedges", CutRule::fromCentre, 15,
           joined({wedgeEnds6(), quad8(0, 1, 4, 3, 6, 13, 9, 12), quad8(1, 2, 5, 4, 7, 14, 10, 13),
                   quad8(2, 0, 3, 5, 8, 12, 11, 14)})};
  t[27] = {"quadratic pyramids", CutRule::fromCentre, 13,
           joined({quad8(0, 3, 2, 1, 8, 7, 6, 5), triangle6(0, 1, 4, 5, 10, 9), triangle6(1, 2, 4, 6, 11, 10),
                   triangle6(2, 3, 4, 7, 12, 11), triangle6(3, 0, 4, 8, 9, 12)})};
  t[29] = {"triquadratic hexahedra", CutRule::fromCentre, 27,
           joined({hexahedronSides9(), quad9(0, 3, 2, 1, 11, 10, 9, 8, 24), quad9(4, 5, 6, 7, 12, 13, 14, 15, 25)}),
           26};
  t[31] = {"quadratic-linear wedges", CutRule::fromCentre, 12,
           joined({wedgeEnds6(), quad6(0, 1, 4, 3, 6, 9), quad6(1, 2, 5, 4, 7, 10), quad6(2, 0, 3, 5, 8, 11)})};
  t[32] = {"biquadratic-quadratic wedges", CutRule::fromCentre, 18,
           joined({wedgeEnds6(), quad9(0, 1, 4, 3, 6, 13, 9, 12, 15), quad9(1, 2, 5, 4, 7, 14, 10, 13, 16),
                   quad9(2, 0, 3, 5, 8, 12, 11, 14, 17)})};
  t[33] = {"biquadratic-quadratic hexahedra", CutRule::fromCentre, 24,
           joined({hexahedronSides9(), quad8(0, 3, 2, 1, 11, 10, 9, 8), quad8(4, 5, 6, 7, 12, 13, 14, 15)})};
  t[37] = {
      "triquadratic pyramids", CutRule::fromCentre, 19,
      joined({quad9(0, 3, 2, 1, 8, 7, 6, 5, 13), triangle7(0, 1, 4, 5, 10, 9, 14), triangle7(1, 2, 4, 6, 11, 10, 15),
              triangle7(2, 3, 4, 7, 12, 11, 16), triangle7(3, 0, 4, 8, 9, 12, 17)}),
      18};
}

void addUnsupportedCells(Table& t) {
  constexpr std::pair<int, const char*> kUnsupported[] = {
      {41, "convex point sets"},       {55, "parametric tetrahedra"}, {56, "parametric hexahedra"},
      {64, "higher-order tetrahedra"}, {65, "higher-order wedges"},   {66, "higher-order pyramids"},
      {67, "higher-order hexahedra"},  {71, "Lagrange tetrahedra"},   {72, "Lagrange hexahedra"},
      {73, "Lagrange wedges"},         {74, "Lagrange pyramids"},     {78, "Bezier tetrahedra"},
      {79, "Bezier hexahedra"},        {80, "Bezier wedges"},         {81, "Bezier pyramids"}};
  for (const auto& [type, name] : kUnsupported) t[type] = {name, CutRule::unsupported};
}

Table makeTable() {
  Table t;
  addSmallCells(t);
  addLinearCells(t);
  addQuadraticCells(t);
  addUnsupportedCells(t);
  return t;
}

}  // namespace

const CellShape& cellShape(std::uint8_t vtkType) {
  static const Table table = makeTable();
  return table[vtkType];
}

}  // namespace havs
