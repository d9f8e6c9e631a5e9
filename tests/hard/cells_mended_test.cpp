// Cells that are mended or left out: flat, inverted, duplicated ones.
#include "hard/cell_checks.h"
#include "hard/hard_meshes.h"

namespace havs::test {
namespace {

using CellsMended = CellsTest;

TetMesh soundMesh() { return withPointData(box(3, Cut::five, 0.2)); }

/// A cell's corner that a boundary face of it is opposite to; 4: it has none.
std::size_t cornerBehindBoundary(const Faces& faces, std::size_t cell) {
  std::size_t corner = 0;
  while (corner < 4 && !faces.isBoundary(faces.ofCell[cell][corner])) ++corner;
  return corner;
}

/// Flat cells on the boundary, or inside only: of faces of the sound mesh, split at their middle.
TetMesh withFlatCells(bool onBoundary, std::size_t& count) {
  const TetMesh sound = soundMesh();
  const Faces faces = buildFaces(sound);
  TetMesh mesh = sound;
  count = 0;
  for (std::size_t c = 0; c < sound.tetrahedra.size(); c += 2) {
    const std::size_t corner = cornerBehindBoundary(faces, c);
    if ((corner < 4) != onBoundary) continue;
    std::array<double, 4> shares;
    shares.fill(1.0 / 3);
    shares[onBoundary ? corner : 0] = 0;
    splitCell(mesh, c, shares);
    ++count;
  }
  return mesh;
}

TEST_F(CellsMended, FlatCellsInside) {
  tellCells(
      "four points of a plane between good cells: a normal of no length, 0 / 0 in barycentric coordinates; left "
      "out, its neighbours' faces no longer fit",
      "left out and counted; each neighbour keeps a boundary face, and the inside-count joins what touches");
  std::size_t count = 0;
  const TetMesh mesh = withFlatCells(false, count);
  const HardPicture picture = expectCells(mesh), expected = expectCells(soundMesh());
  expectDefects(picture.prepared, "flat_cells", count);
  expectSame("the truth without flat cells", picture.truth, expected.truth, 1e-6);
}

TEST_F(CellsMended, FlatCellsAtTheSurface) {
  tellCells("flat cells on the boundary make a surface that is there twice", "left out and counted");
  std::size_t count = 0;
  const TetMesh mesh = withFlatCells(true, count);
  const HardPicture picture = expectCells(mesh), expected = expectCells(soundMesh());
  expectDefects(picture.prepared, "flat_cells", count);
  expectSame("the truth without flat cells", picture.truth, expected.truth, 1e-6);
}

TEST_F(CellsMended, InvertedCellsAmongGoodOnes) {
  tellCells(
      "cells whose points are in the left-handed order, inside and at the surface: their faces look out of the "
      "next cell, entries count as exits",
      "turned and counted; every picture is that of the sound mesh");
  TetMesh mesh = soundMesh();
  std::size_t count = 0;
  for (std::size_t c = 0; c < mesh.tetrahedra.size(); c += 3, ++count)
    std::swap(mesh.tetrahedra[c][1], mesh.tetrahedra[c][3]);
  const HardPicture picture = expectCells(mesh), expected = expectCells(soundMesh());
  expectDefects(picture.prepared, "inverted_cells", count);
  // Faces' corners come in another order, so floats round otherwise: twice the bound of OpenGL's traced pixels.
  expectSamePictures(picture, expected, 4e-4);
}

TEST_F(CellsMended, AllCellsInverted) {
  tellCells("a mesh written left-handed throughout is empty to codes that leave such cells out", "turned and counted");
  TetMesh mesh = withCellData(soundMesh());
  mesh.pointFields.clear();
  const HardPicture expected = expectCells(mesh, cellDataBounds());
  for (Tetrahedron& cell : mesh.tetrahedra) std::swap(cell[0], cell[1]);
  const HardPicture picture = expectCells(mesh, cellDataBounds());
  expectDefects(picture.prepared, "inverted_cells", mesh.tetrahedra.size());
  expectSame("the truths", picture.truth, expected.truth, 1e-7);
}

TEST_F(CellsMended, DuplicatedCells) {
  tellCells(
      "a cell listed again, its points in the same, another or the inverted order: counted twice it is twice as "
      "opaque, and its faces belong to three cells",
      "the first stays, later ones are left out and counted, whatever the order of their points");
  TetMesh mesh = withCellData(soundMesh());
  mesh.pointFields.clear();
  const HardPicture expected = expectCells(mesh, cellDataBounds());
  const std::size_t cells = mesh.tetrahedra.size();
  for (std::size_t c = 0; c < cells; c += 4) {
    auto [i, j, k, l] = mesh.tetrahedra[c];
    const Tetrahedron copies[] = {{i, j, k, l}, {j, k, i, l}, {i, k, j, l}};
    mesh.tetrahedra.push_back(copies[c / 4 % 3]);
    mesh.cellFields[0].values.push_back(0.5);
  }
  const HardPicture picture = expectCells(mesh, cellDataBounds());
  expectDefects(picture.prepared, "duplicate_cells", mesh.tetrahedra.size() - cells);
  expectSame("the truths", picture.truth, expected.truth, 1e-7);
}

TEST_F(CellsMended, CellsThatNameAPointTwice) {
  tellCells("a cell that names one point twice is a triangle: its faces match those of others, or each other",
            "it encloses nothing: left out and counted as flat");
  TetMesh mesh = soundMesh();
  const HardPicture expected = expectCells(mesh);
  mesh.tetrahedra.insert(mesh.tetrahedra.end(), {{0, 1, 1, 5}, {2, 2, 2, 2}, {3, 7, 9, 3}});
  const HardPicture picture = expectCells(mesh);
  expectDefects(picture.prepared, "flat_cells", 3);
  expectSame("the truths", picture.truth, expected.truth, 1e-7);
}

TEST_F(CellsMended, NothingButFlatCells) {
  tellCells("a mesh that encloses nothing has no picture", "refused, with the number of cells and what to look at");
  TetMesh mesh = soundMesh();
  for (Vec3& p : mesh.points) p.z = 0;
  expectRefused(rampScene(), mesh, "encloses a volume");
}

}  // namespace
}  // namespace havs::test
