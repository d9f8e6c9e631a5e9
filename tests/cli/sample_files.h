#pragma once
#include <string>

#include "support/temporary_folder.h"

namespace havs::test {

/// The unit cube in six tetrahedra around its diagonal; point attribute: x + y + z, region attribute: the cell's
/// number.
inline const std::string kCubeNode =
    "8 3 1 0\n"
    "0 0 0 0 0\n1 1 0 0 1\n2 0 1 0 1\n3 1 1 0 2\n"
    "4 0 0 1 1\n5 1 0 1 2\n6 0 1 1 2\n7 1 1 1 3\n";
inline const std::string kCubeEle =
    "6 4 1\n"
    "0 0 1 3 7 0\n1 0 3 2 7 1\n2 0 2 6 7 2\n3 0 6 4 7 3\n4 0 4 5 7 4\n5 0 5 1 7 5\n";

/// The cube's surface as a TetGen input.
inline const std::string kCubePoly =
    "8 3 0 0\n"
    "0 0 0 0\n1 1 0 0\n2 0 1 0\n3 1 1 0\n4 0 0 1\n5 1 0 1\n6 0 1 1\n7 1 1 1\n"
    "6 0\n1\n4 0 1 3 2\n1\n4 4 5 7 6\n1\n4 0 1 5 4\n1\n4 2 3 7 6\n1\n4 0 2 6 4\n1\n4 1 3 7 5\n"
    "0\n0\n";

/// A legacy VTK file with one triangle and no cell of three dimensions.
inline const std::string kTriangleVtk =
    "# vtk DataFile Version 3.0\nsurface\nASCII\nDATASET UNSTRUCTURED_GRID\n"
    "POINTS 3 float\n0 0 0 1 0 0 0 1 0\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n";

/// Writes NAME.node and NAME.ele.
inline void writeTetgenMesh(const TemporaryFolder& folder, const std::string& name, const std::string& node,
                            const std::string& ele) {
  folder.write(name + ".node", node);
  folder.write(name + ".ele", ele);
}

}  // namespace havs::test
