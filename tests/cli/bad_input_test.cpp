// Files that are missing, broken or empty of what is needed.
#include "cli/refused.h"

namespace havs::test {
namespace {

class BadInput : public RefusedRun {
 protected:
  BadInput() {
    std::filesystem::create_directory(folder / "folder.vtk");
    folder.write("empty.node", "");
    folder.write("picture.jpg", "x");
    folder.write("lonely.node", kCubeNode);
    writeTetgenMesh(folder, "cut", kCubeNode.substr(0, kCubeNode.size() / 2), kCubeEle);
    writeTetgenMesh(folder, "cutcells", kCubeNode, kCubeEle.substr(0, kCubeEle.size() / 2));
    writeTetgenMesh(folder, "text", replaced(kCubeNode, "3 1 1 0 2", "3 1 one 0 2"), kCubeEle);
    writeTetgenMesh(folder, "range", kCubeNode, replaced(kCubeEle, "0 2 6 7", "0 2 6 8"));
    writeTetgenMesh(folder, "negative", kCubeNode, replaced(kCubeEle, "0 2 6 7", "0 2 6 -7"));
    writeTetgenMesh(folder, "nocells", kCubeNode, "0 4 0\n");
    writeTetgenMesh(folder, "huge", replaced(kCubeNode, "8 3 1 0", "8000000000000 3 1 0"), kCubeEle);
    writeTetgenMesh(folder, "flat", "4 3 1 0\n0 0 0 0 0\n1 1 0 0 1\n2 0 1 0 1\n3 1 1 0 2\n", "1 4 0\n0 0 1 2 3\n");
    writeTetgenMesh(folder, "nan", "4 3 1 0\n0 0 0 0 nan\n1 1 0 0 nan\n2 0 1 0 nan\n3 0 0 1 nan\n",
                    "1 4 0\n0 0 1 2 3\n");
    writeTetgenMesh(folder, "nofield", "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n", "1 4 0\n0 0 1 2 3\n");
    folder.write("triangle.vtk", kTriangleVtk);
    folder.write("broken.vtu", "<VTKFile type=\"UnstructuredGrid\"><Unstruc");
    folder.write("broken.json", "{\"points\": [");
    folder.write("unordered.json", R"({"version": 1, "points": [{"scalar": 1, "color": [1, 1, 1], "opacity": 7}]})");
    folder.write("open.poly", "3 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n1 0\n1\n3 0 1 2\n0\n0\n");
  }

  static std::string replaced(std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
  }
};

TEST_P(BadInput, IsRefused) { expectRefused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Mesh, BadInput,
    testing::Values(Refused{"MissingFile", {"render", "missing.node", "-o", "a.png"}, "missing.node"},
                    Refused{"Directory", {"render", "folder.vtk", "-o", "a.png"}, "director"},
                    Refused{"EmptyFile", {"render", "empty.node", "-o", "a.png"}, "empty"},
                    Refused{"UnknownExtension", {"render", "picture.jpg", "-o", "a.png"}, "known: .node"},
                    Refused{"NodeWithoutEle", {"render", "lonely.node", "-o", "a.png"}, "lonely.ele"},
                    Refused{"TruncatedPoints", {"render", "cut.node", "-o", "a.png"}, "cut.node"},
                    Refused{"TruncatedCells", {"render", "cutcells.ele", "-o", "a.png"}, "cutcells.ele"},
                    Refused{"TextInANumber", {"render", "text.node", "-o", "a.png"}, "text.node"},
                    Refused{"IndexOutOfRange", {"render", "range.ele", "-o", "a.png"}, "range.ele"},
                    Refused{"NegativeIndex", {"render", "negative.ele", "-o", "a.png"}, "negative.ele"},
                    Refused{"ZeroCells", {"render", "nocells.ele", "-o", "a.png"}, "nocells"},
                    Refused{"HugeCount", {"render", "huge.node", "-o", "a.png"}, "huge.node"},
                    Refused{"OnlyFlatCells", {"render", "flat.node", "-o", "a.png"}, "encloses a volume"},
                    Refused{"NoFiniteScalar", {"render", "nan.node", "-o", "a.png"}, "finite"},
                    Refused{"NoField", {"render", "nofield.node", "-o", "a.png"}, "field"},
                    Refused{"OnlySurfaces", {"render", "triangle.vtk", "-o", "a.png"}, "triangle.vtk"},
                    Refused{"BrokenXml", {"render", "broken.vtu", "-o", "a.png"}, "broken.vtu"},
                    Refused{"OpenSurface", {"mesh", "open.poly", "-o", "a.node"}, "open.poly"},
                    Refused{"InfoOfMissingFile", {"info", "missing.vtu"}, "missing.vtu"},
                    Refused{"MeshOfMissingFile", {"mesh", "missing.poly", "-o", "a.node"}, "missing.poly"}),
    nameOfCase);

INSTANTIATE_TEST_SUITE_P(
    Other, BadInput,
    testing::Values(
        Refused{"UnknownField", {"render", "cube.node", "--field", "presure", "-o", "a.png"}, "presure"},
        Refused{"UnknownComponent", {"render", "cube.node", "--field", "attribute0:7", "-o", "a.png"}, "component"},
        Refused{"InfoOfUnknownField", {"info", "cube.node", "--field", "presure"}, "presure"},
        Refused{"UnknownPreset", {"render", "cube.node", "--tf", "rainbw", "-o", "a.png"}, "'rainbow'"},
        Refused{
            "MissingTransferFunction", {"render", "cube.node", "--tf", "missing.json", "-o", "a.png"}, "missing.json"},
        Refused{"BrokenTransferFunction", {"render", "cube.node", "--tf", "broken.json", "-o", "a.png"}, "broken.json"},
        Refused{"OpacityOutOfRange", {"render", "cube.node", "--tf", "unordered.json", "-o", "a.png"}, "opacity"},
        Refused{"BrokenExpression", {"mesh", "cube.node", "-o", "a.node", "--scalar", "r=sqrt(x"}, "sqrt(x"},
        Refused{"ExpressionWithoutName", {"mesh", "cube.node", "-o", "a.node", "--scalar", "=x"}, "NAME=EXPRESSION"},
        Refused{"ClipPlaneTooFarAway",
                {"render", "cube.node", "--clip-plane", "1e308,1e308,1e308,1,1,1", "-o", "a.png"},
                "too far away"}),
    nameOfCase);

#if !HAVS_WITH_VTK
INSTANTIATE_TEST_SUITE_P(BuildWithoutVtk, BadInput,
                         testing::Values(Refused{"Reads", {"info", "triangle.vtk"}, "-DHAVS_WITH_VTK=ON"},
                                         Refused{"Writes", {"mesh", "cube.node", "-o", "a.vtu"}, "-DHAVS_WITH_VTK=ON"}),
                         nameOfCase);
#endif
#if !HAVS_WITH_TETGEN
INSTANTIATE_TEST_SUITE_P(BuildWithoutTetGen, BadInput,
                         testing::Values(Refused{
                             "Reads", {"mesh", "open.poly", "-o", "a.node"}, "-DHAVS_WITH_TETGEN=ON"}),
                         nameOfCase);
#endif

}  // namespace
}  // namespace havs::test
