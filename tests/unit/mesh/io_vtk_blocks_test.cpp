// Files of several blocks or pieces become one mesh whose cuts conform across them.
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExodusIIWriter.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "io_checks.h"
#include "mesh/faces.h"

namespace havs::test {
namespace {

/// A unit cube at `x`; its points come in the reverse of the usual order when asked for.
vtkSmartPointer<vtkUnstructuredGrid> cubeAt(double x, bool reversed) {
  constexpr double kCorners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                     {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> values;
  values->SetName("x");
  vtkIdType ids[8];
  for (int i = 0; i < 8; ++i) {
    const double* corner = kCorners[reversed ? 7 - i : i];
    ids[reversed ? 7 - i : i] = points->InsertNextPoint(x + corner[0], corner[1], corner[2]);
    values->InsertNextValue(x + corner[0]);
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
  grid->GetPointData()->AddArray(values);
  return grid;
}

void writeVtuPiece(vtkUnstructuredGrid* grid, const std::filesystem::path& file, unsigned char ghost = 0) {
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->InsertNextValue(ghost);
  grid->GetCellData()->AddArray(ghosts);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(grid);
  ASSERT_EQ(writer->Write(), 1);
}

constexpr const char* kTwoPieces = R"(<?xml version="1.0"?>
<VTKFile type="PUnstructuredGrid" version="0.1" byte_order="LittleEndian"><PUnstructuredGrid GhostLevel="0">
<PPointData><PDataArray type="Float64" Name="x"/></PPointData>
<PCellData><PDataArray type="UInt8" Name="vtkGhostType"/></PCellData>
<PPoints><PDataArray type="Float64" Name="Points" NumberOfComponents="3"/></PPoints>
<Piece Source="0.vtu"/><Piece Source="1.vtu"/></PUnstructuredGrid></VTKFile>)";

/// Two cubes side by side: 12 points, no inner boundary, each of the 10 outer squares cut in two.
void expectTwoCubes(const TetMesh& mesh) {
  EXPECT_EQ(mesh.sourceCells, 2u);
  EXPECT_EQ(mesh.points.size(), 12u);
  EXPECT_NEAR(volume(mesh), 2, 1e-12);  // a sum of about a dozen sixths
  EXPECT_EQ(buildFaces(mesh).boundaryCount, 20u);
  expectPointField(
      mesh, "x", [](const Vec3& p) { return p.x; }, 0);
}

TEST(VtkPieces, AreWeldedBeforeTheyAreCut) {
  const Folder folder;
  writeVtuPiece(cubeAt(0, false), folder / "0.vtu");
  writeVtuPiece(cubeAt(1, true), folder / "1.vtu");
  expectTwoCubes(readMesh(folder.write("whole.pvtu", kTwoPieces)));
}

TEST(VtkPieces, GhostCellsAreLeftOut) {
  const Folder folder;
  writeVtuPiece(cubeAt(1, true), folder / "1.vtu", vtkDataSetAttributes::DUPLICATECELL);
  expectRefused(folder / "1.vtu", "no");  // nothing but a ghost
  writeVtuPiece(cubeAt(0, false), folder / "0.vtu");
  const TetMesh mesh = readMesh(folder.write("whole.pvtu", kTwoPieces));
  EXPECT_EQ(mesh.sourceCells, 1u);
  EXPECT_NEAR(volume(mesh), 1, 1e-12);
  EXPECT_THAT(mesh.notes, testing::Contains(testing::HasSubstr("left out 1 ghost")));
}

TEST(VtkPieces, AMissingPieceIsAnError) {
  const Folder folder;
  writeVtuPiece(cubeAt(0, false), folder / "0.vtu");
  expectRefused(folder.write("whole.pvtu", kTwoPieces), "piece 1");
}

TEST(Exodus, ElementBlocksBecomeOneMesh) {
  const Folder folder;
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, cubeAt(0, false));
  blocks->SetBlock(1, cubeAt(1, true));
  vtkNew<vtkExodusIIWriter> writer;
  writer->SetFileName((folder / "cubes.exo").c_str());
  writer->SetInputData(blocks);
  writer->SetStoreDoubles(1);
  ASSERT_EQ(writer->Write(), 1);
  expectTwoCubes(readMesh(folder / "cubes.exo"));
}

}  // namespace
}  // namespace havs::test
