// Surfaces filled by TetGen: volumes in closed form, the same solid from every format, and the inputs of meshes/.
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "io_checks.h"
#include "mesh/faces.h"

namespace havs::test {
namespace {

const std::filesystem::path kMeshes = HAVS_MESHES;
constexpr double kRounding = 1e-12;  // sums of up to a few thousand volumes in double

// A tetrahedron of legs 1, 2, 3: volume 1.
constexpr std::array<std::array<float, 3>, 4> kCorners{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}};
constexpr std::array<std::array<int, 3>, 4> kTriangles{{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};

std::string asciiStl() {
  std::string text = "solid tet\n";
  for (const auto& triangle : kTriangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int corner : triangle) {
      text += "vertex";
      for (const float x : kCorners[static_cast<std::size_t>(corner)]) text += " " + std::to_string(x);
      text += "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid tet\n";
}

template <class T>
void append(std::string& bytes, T value, bool bigEndian = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (bigEndian != (std::endian::native == std::endian::big)) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

std::string binaryStl() {
  std::string bytes = "solid, though binary";
  bytes.resize(80, ' ');
  append(bytes, static_cast<std::uint32_t>(kTriangles.size()));
  for (const auto& triangle : kTriangles) {
    bytes.append(12, '\0');
    for (const int corner : triangle)
      for (const float x : kCorners[static_cast<std::size_t>(corner)]) append(bytes, x);
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string off() {
  std::string text = "OFF\n# a comment\n4 4 0\n";
  for (const auto& p : kCorners)
    text += std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
  for (const auto& t : kTriangles)
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
  return text;
}

std::string plyHeader(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment a tetrahedron\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
         "z\nproperty uchar red\n"
         "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string asciiPly() {
  std::string text = plyHeader("ascii");
  for (const auto& p : kCorners)
    text += std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + " 255\n";
  for (const auto& t : kTriangles)
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
  return text;
}

std::string binaryPly(bool bigEndian) {
  std::string bytes = plyHeader(bigEndian ? "binary_big_endian" : "binary_little_endian");
  for (const auto& p : kCorners) {
    for (const float x : p) append(bytes, x, bigEndian);
    append(bytes, std::uint8_t{255});
  }
  for (const auto& t : kTriangles) {
    append(bytes, std::uint8_t{3});
    for (const std::int32_t corner : t) append(bytes, corner, bigEndian);
  }
  return bytes;
}

constexpr const char* kSmesh =
    "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 2 0\n3 0 0 3\n4 1\n3 0 2 1 7\n3 0 1 3 7\n3 0 3 2 7\n3 1 2 3 7\n0\n0\n";

TEST(TetgenFormats, EveryOneGivesTheSameTetrahedron) {
  const Folder folder;
  const std::filesystem::path files[] = {folder.write("a.stl", asciiStl()),
                                         folder.write("b.stl", binaryStl()),
                                         folder.write("c.off", off()),
                                         folder.write("d.ply", asciiPly()),
                                         folder.write("e.ply", binaryPly(false)),
                                         folder.write("f.ply", binaryPly(true)),
                                         folder.write("g.smesh", kSmesh)};
  for (const auto& file : files) {
    SCOPED_TRACE(file);
    const TetMesh mesh = readMesh(file, {.tetgenSwitches = "p"});
    EXPECT_EQ(mesh.points.size(), 4u);
    ASSERT_EQ(mesh.tetrahedra.size(), 1u);
    EXPECT_NEAR(signedVolume(mesh, mesh.tetrahedra[0]), 1, kRounding);  // right-handed
  }
}

TEST(TetgenFormats, PointsMayBeInANodeFileBeside) {
  const Folder folder;
  folder.write("tet.node", "4 3 1 0\n1 0 0 0 5\n2 1 0 0 6\n3 0 2 0 7\n4 0 0 3 8\n");
  const auto file = folder.write("tet.poly", "0 3 0 0\n4 0\n1\n3 1 3 2\n1\n3 1 2 4\n1\n3 1 4 3\n1\n3 2 3 4\n0\n");
  const TetMesh mesh = readMesh(file, {.tetgenSwitches = "p"});
  EXPECT_NEAR(volume(mesh), 1, kRounding);
  ASSERT_EQ(mesh.pointFields.size(), 1u);
  EXPECT_EQ(mesh.pointFields[0].values, (std::vector<double>{5, 6, 7, 8}));
}

TEST(TetgenSwitches, VolumeLimitHolds) {
  constexpr double kLargest = 0.01;
  const TetMesh mesh = readMesh(kMeshes / "cube.poly", {.tetgenSwitches = "-pq1.4a0.01"});
  EXPECT_GT(mesh.tetrahedra.size(), 100u);  // at least 1 / 0.01
  EXPECT_NEAR(volume(mesh), 1, kRounding);
  for (const Tetrahedron& t : mesh.tetrahedra) {
    ASSERT_GT(signedVolume(mesh, t), 0);
    ASSERT_LE(signedVolume(mesh, t), kLargest * (1 + kRounding));
  }
}

TEST(TetgenSwitches, RegionsBecomeACellField) {
  const TetMesh mesh = readMesh(kMeshes / "nested_shells.poly", {.tetgenSwitches = "pqA"});
  const Field* region = find(mesh.cellFields, "region");
  ASSERT_NE(region, nullptr);
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
    Vec3 center{0};
    for (const Index corner : mesh.tetrahedra[i]) center += mesh.points[corner] / 4.0;
    // The shell at 0.75 is a polyhedron that dips inside its sphere by less than 0.03.
    if (glm::length(center) > 0.75) {
      ASSERT_EQ(region->values[i], 1);
    }
    if (glm::length(center) < 0.72) {
      ASSERT_EQ(region->values[i], 2);
    }
    ASSERT_GT(glm::length(center), 0.3);  // the innermost sphere, radius 0.4 less its dips, is hollow
  }
}

TEST(TetgenInputs, PointAttributesAreKept) {
  const TetMesh mesh = readMesh(kMeshes / "cube.poly", {.tetgenSwitches = "p"});
  expectPointField(
      mesh, "attribute0", [](const Vec3& p) { return p.x + p.y + p.z; }, 0);
}

/// Edges of the boundary - faces + points: 2 for a ball, less 2 for each tunnel, plus 2 for each further shell.
std::int64_t eulerCharacteristic(const TetMesh& mesh) {
  const Faces faces = buildFaces(mesh);
  std::vector<char> used(mesh.points.size());
  std::int64_t triangles = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!faces.isBoundary(f)) continue;
    ++triangles;
    for (const Index corner : faces.vertices[f]) used[corner] = 1;
  }
  return std::ranges::count(used, 1) - triangles / 2;  // a closed surface has 3/2 edges a triangle
}

TEST(TetgenInputs, HaveTheirTopology) {
  EXPECT_EQ(eulerCharacteristic(readMesh(kMeshes / "cube.poly")), 2);
  EXPECT_EQ(eulerCharacteristic(readMesh(kMeshes / "bracket.poly")), 2 - 2 * 3);    // three holes
  EXPECT_EQ(eulerCharacteristic(readMesh(kMeshes / "nested_shells.poly")), 2 + 2);  // outside and hollow
  EXPECT_EQ(eulerCharacteristic(readMesh(kMeshes / "torus_knot.off", {.tetgenSwitches = "p"})), 0);  // a torus
}

TEST(TetgenInputs, HaveTheirVolume) {
  // The L less three 24-gons of radius 0.4 through plates of 0.5.
  const double polygon = 0.5 * 24 * 0.4 * 0.4 * std::sin(2 * std::acos(-1.0) / 24);
  const double expected = (4 * 0.5 + 2.5 * 0.5) * 2 - 3 * polygon * 0.5;
  // Coordinates are written to six digits: the polygon's perimeter times 5e-7.
  EXPECT_NEAR(volume(readMesh(kMeshes / "bracket.poly")), expected, 1e-5);
}

TEST(NodeEleInput, RampIsACubeWithItsField) {
  const TetMesh mesh = readMesh(kMeshes / "ramp.node");
  EXPECT_EQ(mesh.points.size(), 125u);
  EXPECT_EQ(mesh.tetrahedra.size(), 384u);
  EXPECT_NEAR(volume(mesh), 1, kRounding);
  for (const Tetrahedron& t : mesh.tetrahedra) ASSERT_GT(signedVolume(mesh, t), 0);
  expectPointField(
      mesh, "attribute0", [](const Vec3& p) { return p.x + 2 * p.y + 3 * p.z; }, 1e-12);
  expectPointField(
      mesh, "attribute1", [](const Vec3& p) { return glm::dot(p, p); }, 1e-12);
}

}  // namespace
}  // namespace havs::test
