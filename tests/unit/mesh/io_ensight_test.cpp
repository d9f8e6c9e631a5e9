// EnSight Gold, ASCII: one part with a tetrahedron, one with triangles.
#include "io_checks.h"

namespace havs::test {
namespace {

constexpr const char* kCase = R"(FORMAT
type: ensight gold
GEOMETRY
model: tet.geo
VARIABLE
scalar per node: heat tet.heat
)";
constexpr const char* kGeometry = R"(a tetrahedron
and a triangle
node id assign
element id assign
part
         1
volume
coordinates
         4
 0.00000e+00
 1.00000e+00
 0.00000e+00
 0.00000e+00
 0.00000e+00
 0.00000e+00
 1.00000e+00
 0.00000e+00
 0.00000e+00
 0.00000e+00
 0.00000e+00
 1.00000e+00
tetra4
         1
         1         2         3         4
part
         2
surface
coordinates
         3
 0.00000e+00
 1.00000e+00
 0.00000e+00
 0.00000e+00
 0.00000e+00
 1.00000e+00
 5.00000e+00
 5.00000e+00
 5.00000e+00
tria3
         1
         1         2         3
)";
constexpr const char* kHeat = R"(heat
part
         1
coordinates
 1.00000e+00
 2.00000e+00
 3.00000e+00
 4.00000e+00
part
         2
coordinates
 9.00000e+00
 9.00000e+00
 9.00000e+00
)";

TEST(EnSight, VolumePartsAreRead) {
  const Folder folder;
  folder.write("tet.geo", kGeometry);
  folder.write("tet.heat", kHeat);
  const TetMesh mesh = readMesh(folder.write("tet.case", kCase));
  ASSERT_EQ(mesh.tetrahedra.size(), 1u);
  EXPECT_EQ(mesh.points.size(), 4u);
  EXPECT_NEAR(volume(mesh), 1.0 / 6, 1e-7);  // float coordinates
  expectPointField(
      mesh, "heat", [](const Vec3& p) { return 1 + p.x + 2 * p.y + 3 * p.z; }, 1e-6);  // float values
  EXPECT_THAT(mesh.notes, testing::Contains(testing::HasSubstr("left out 1 block")));
}

TEST(EnSight, AMissingGeometryIsAnError) {
  const Folder folder;
  expectRefused(folder.write("tet.case", kCase), "tet.geo");
}

}  // namespace
}  // namespace havs::test
