// Broken surfaces and switches: each is refused by one clear line, and TetGen's own chatter stays away.
#include "io_checks.h"

namespace havs::test {
namespace {

struct BadSurface {
  const char* name;
  std::string content;
  const char* part;  ///< of the message
};

constexpr const char* kPoints = "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 2 0\n3 0 0 3\n";

std::string poly(const std::string& facets) { return kPoints + facets; }

/// Two tetrahedra that cut through each other.
constexpr const char* kCrossing =
    "OFF\n8 8 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n1 1 -1\n5 1 -1\n1 5 -1\n1 1 3\n"
    "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n3 4 6 5\n3 4 5 7\n3 4 7 6\n3 5 6 7\n";

class BadSurfaces : public testing::TestWithParam<BadSurface> {};

TEST_P(BadSurfaces, AreRefusedByOneLine) {
  const Folder folder;
  expectRefused(folder.write(GetParam().name, GetParam().content), GetParam().part);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadSurfaces,
    testing::Values(
        BadSurface{"words.poly", "hello\n", "words.poly:1"},
        BadSurface{"cut.poly", "4 3 0 0\n0 0 0 0\n1 1 0 0\n", "cut.poly"},
        BadSurface{"lie.poly", "2000000000 3 0 0\n0 0 0 0\n", "lie.poly:1"},
        BadSurface{"negative.poly", "-4 3 0 0\n", "negative.poly:1"},
        BadSurface{"letter.poly", "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 x 0\n3 0 0 3\n", "letter.poly:4"},
        BadSurface{"nan.poly", "4 3 0 0\n0 0 0 0\n1 nan 0 0\n2 0 2 0\n3 0 0 3\n", "not finite"},
        BadSurface{"flat.poly", "4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n4 3 0 2\n3 0 2\n", "2 dimensions"},
        BadSurface{"nofacets.poly", poly("0 0\n"), "no facets"},
        BadSurface{"range.poly", poly("4 0\n1\n3 0 2 9\n1\n3 0 1 3\n"),
                   "range.poly:8: a polygon has the point number 9"},
        BadSurface{"below.poly", poly("4 0\n1\n3 0 2 -1\n1\n3 0 1 3\n"), "out of range"},
        BadSurface{"fewfacets.poly", poly("4 0\n1\n3 0 2 1\n"), "fewfacets.poly"},
        BadSurface{"open.poly", poly("4 0\n1\n3 0 2 1\n1\n3 0 1 3\n1\n3 0 3 2\n1\n3 0 3 2\n0\n0\n"), "duplicated"},
        BadSurface{"gap.off", "OFF\n5 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n5 5 5\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 4\n",
                   "gap"},
        BadSurface{"words.off", "OFFSIDE\n", "words.off:1"}, BadSurface{"lie.off", "OFF\n900000000 4 0\n", "lie.off:2"},
        BadSurface{"range.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 4\n3 0 1 2\n3 0 1 2\n3 0 1 2\n",
                   "range.off:7"},
        BadSurface{"crossing.off", kCrossing, "intersects itself"}, BadSurface{"text.stl", "hello\n", "no STL file"},
        BadSurface{"cut.stl", "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\n", "cut short"},
        BadSurface{"letter.stl", "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 q\n", "letter.stl:4"},
        BadSurface{"text.ply", "hello\n", "no PLY file"}, BadSurface{"cut.ply", "ply\nformat ascii 1.0\n", "cut short"},
        BadSurface{"lie.ply",
                   "ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty float x\nproperty float y\nproperty "
                   "float z\nend_header\n",
                   "99999999999"},
        BadSurface{"noz.ply",
                   "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
                   "no property z"}),
    [](const auto& row) {
      std::string name = row.param.name;
      std::ranges::replace(name, '.', '_');
      return name;
    });

TEST(BadSwitches, AreRefused) {
  const std::filesystem::path cube = std::filesystem::path(HAVS_MESHES) / "cube.poly";
  const auto messageFor = [&](const std::string& switches) {
    try {
      readMesh(cube, {.tetgenSwitches = switches});
    } catch (const Error& error) {
      EXPECT_EQ(error.exitStatus(), 2) << switches;
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(messageFor("pqZ"), testing::HasSubstr("'Z' is no switch"));
  EXPECT_THAT(messageFor("p q"), testing::HasSubstr("' ' is no switch"));
  EXPECT_THAT(messageFor("pq0.5"), testing::HasSubstr("1 to 100"));
  EXPECT_THAT(messageFor("pq1.4a0"), testing::HasSubstr("after a"));
  EXPECT_THAT(messageFor("pa1e999"), testing::HasSubstr("after a"));
  EXPECT_THAT(messageFor("r"), testing::HasSubstr("no switch"));
  EXPECT_THAT(messageFor(std::string(1000, 'q')), testing::HasSubstr("too long"));
}

}  // namespace
}  // namespace havs::test
