// Bad files: one clear message each, with file and line; no crash, no hang, no memory taken for an empty promise.
#include <gmock/gmock.h>

#include "mesh/read.h"
#include "unit/mesh/mesh_checks.h"

namespace havs {
namespace {
using testing::AllOf;
using testing::HasSubstr;

std::string readError(const std::filesystem::path& file, const ReadOptions& options = {}) {
  return test::inputError([&] { readMesh(file, options); });
}

struct BadPair {
  const char* name;
  const char* node;
  const char* ele;
  const char* place;    ///< file and line
  const char* message;  ///< part of what is said
};

const char* const kNode = "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n";
const char* const kEle = "1 4 0\n1 1 2 3 4\n";

class BadNodeEle : public testing::TestWithParam<BadPair> {};

TEST_P(BadNodeEle, SaysWhereAndWhat) {
  const test::TemporaryFolder folder;
  folder.write("m.node", GetParam().node);
  folder.write("m.ele", GetParam().ele);
  EXPECT_THAT(readError(folder / "m.node"), AllOf(HasSubstr(GetParam().place), HasSubstr(GetParam().message)));
}

INSTANTIATE_TEST_SUITE_P(
    All, BadNodeEle,
    testing::Values(
        BadPair{"TruncatedPoints", "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0.0000 1.0000 0.00000\n", kEle,
                "m.node:5:", "ends after 3 of 4"},
        BadPair{"TruncatedInALine", "2 3 0 0\n1 0 0 0\n2 1.000\n", kEle, "m.node:3:", "y is missing"},
        BadPair{"TruncatedCells", kNode, "2 4 0\n1 1 2 3 4\n\n\n\n\n\n\n\n\n\n\n\n", "m.ele:14:", "ends after 1 of 2"},
        BadPair{"TextInANumber", "4 3 0 0\n1 0 0 0\n2 1 0x 0\n3 0 1 0\n4 0 0 1\n", kEle,
                "m.node:3:", "'0x' is no number"},
        BadPair{"TextInAPointNumber", kNode, "1 4 0\n1 1 2 three 4\n", "m.ele:2:", "'three' is no whole number"},
        BadPair{"RealAsAPointNumber", kNode, "1 4 0\n1 1 2 3.5 4\n", "m.ele:2:", "'3.5' is no whole number"},
        BadPair{"PointNumberTooHigh", kNode, "1 4 0\n1 1 2 3 5\n",
                "m.ele:2:", "number 5, out of range: the points are 1 to 4"},
        BadPair{"PointNumberTooLow", kNode, "1 4 0\n1 0 2 3 4\n",
                "m.ele:2:", "number 0, out of range: the points are 1 to 4"},
        BadPair{"NegativePointNumber", kNode, "1 4 0\n1 -1 2 3 4\n", "m.ele:2:", "number -1, out of range"},
        BadPair{"HugePointNumber", kNode, "1 4 0\n1 99999999999999999999 2 3 4\n", "m.ele:2:", "is no whole number"},
        BadPair{"PromiseOfCells", kNode, "1000000000000 4 0\n1 1 2 3 4\n",
                "m.ele:1:", "1000000000000 tetrahedra are promised"},
        BadPair{"PromiseOfPoints", "1000000000000 3 0 0\n1 0 0 0\n", kEle,
                "m.node:1:", "1000000000000 points are promised"},
        BadPair{"PromiseOfAttributes", "4 3 2000000000 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n", kEle,
                "m.node:1:", "number of attributes is 2000000000"},
        BadPair{"NegativeCount", "-4 3 0 0\n", kEle, "m.node:1:", "the number of points is -4"},
        BadPair{"NoPoints", "0 3 0 0\n", kEle, "m.node:1:", "there are no points"},
        BadPair{"NoCells", kNode, "0 4 0\n", "m.ele:1:", "there are no tetrahedra"},
        BadPair{"TwoDimensions", "4 2 0 0\n1 0 0\n2 1 0\n3 0 1\n4 1 1\n", kEle, "m.node:1:", "2 dimensions"},
        BadPair{"FivePointsACell", kNode, "1 5 0\n1 1 2 3 4 1\n", "m.ele:1:", "tetrahedra have 5 points"},
        BadPair{"NumbersFromTwo", "4 3 0 0\n2 0 0 0\n3 1 0 0\n4 0 1 0\n5 0 0 1\n", kEle,
                "m.node:2:", "first point's number is 2"},
        BadPair{"CellsFromTwo", kNode, "1 4 0\n9223372036854775807 1 2 3 4\n",
                "m.ele:2:", "first tetrahedron's number is 9223372036854775807"},
        BadPair{"NumberLeftOut", "4 3 0 0\n1 0 0 0\n2 1 0 0\n4 0 1 0\n5 0 0 1\n", kEle,
                "m.node:4:", "point number 4 stands where 3"},
        BadPair{"MissingAttribute", "4 3 1 0\n1 0 0 0 1\n2 1 0 0\n3 0 1 0 1\n4 0 0 1 1\n", kEle,
                "m.node:3:", "an attribute is missing"},
        BadPair{"OnlyComments", "# nothing\n", kEle, "m.node:2:", "the file ends here"}),
    [](const auto& test) { return std::string(test.param.name); });

struct BadUcd {
  const char* name;
  const char* text;
  const char* place;
  const char* message;
};

class BadUcdFile : public testing::TestWithParam<BadUcd> {};

TEST_P(BadUcdFile, SaysWhereAndWhat) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(readError(folder.write("m.inp", GetParam().text)),
              AllOf(HasSubstr(GetParam().place), HasSubstr(GetParam().message)));
}

#define POINTS "1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"
INSTANTIATE_TEST_SUITE_P(
    All, BadUcdFile,
    testing::Values(
        BadUcd{"MultiStep", "1\ndata\nstep1\n" POINTS, "m.inp:1:", "one number only"},
        BadUcd{"Promise", "4000000000 1 0 0 0\n" POINTS, "m.inp:1:", "4000000000 points are promised"},
        BadUcd{"UnknownCell", "4 1 0 0 0\n" POINTS "1 1 ball 1 2 3 4\n", "m.inp:6:", "'ball' is no type of cell"},
        BadUcd{"UnknownPoint", "4 1 0 0 0\n" POINTS "1 1 tet 1 2 3 9\n", "m.inp:6:", "no point number 9"},
        BadUcd{"TooFewPoints", "4 1 0 0 0\n" POINTS "1 1 tet 1 2 3\n", "m.inp:6:", "is missing"},
        BadUcd{"MidNodes", "4 1 0 0 0\n" POINTS "1 1 tet 1 2 3 4 1 2 3 4 1 2\n", "m.inp:6:", "more than 4 points"},
        BadUcd{"NoData", "4 1 1 0 0\n" POINTS "1 1 tet 1 2 3 4\n", "m.inp:7:", "the number of fields should follow"},
        BadUcd{"TextAsMaterial", "4 1 0 0 0\n" POINTS "1 2x tet 1 2 3 4\n", "m.inp:6:", "'2x' is no number"},
        BadUcd{"PromiseOfValues", "4 1 1 0 0\n" POINTS "1 1 tet 1 2 3 4\n2 9 8\na\nb\n1 5\n2 6\n3 6\n4 6\n",
               "m.inp:9:", "17 each, are promised"},
        BadUcd{"HugePointNumber", "4 1 0 0 0\n" POINTS "1 1 tet 1 2 3 -9223372036854775808\n",
               "m.inp:6:", "no point number -9223372036854775808"},
        BadUcd{"DataCutShort", "4 1 1 0 0\n" POINTS "1 1 tet 1 2 3 4\n1 1\na, b\n1 5\n2 6\n",
               "m.inp:11:", "the values of point 3 of 4"},
        BadUcd{"DataTwice", "4 1 1 0 0\n" POINTS "1 1 tet 1 2 3 4\n1 1\na, b\n1 5\n1 6\n3 7\n4 8\n",
               "m.inp:10:", "point number 1 gets values twice"},
        BadUcd{"PointTwice", "4 1 0 0 0\n1 0 0 0\n2 1 0 0\n2 0 1 0\n4 0 0 1\n1 1 tet 1 2 3 4\n",
               "m.inp:4:", "point number 2 comes twice"},
        BadUcd{"OnlySurfaces", "4 1 0 0 0\n" POINTS "1 1 tri 1 2 3\n", "m.inp:", "no solid cells"},
        BadUcd{"Binary",
               "\x07"
               "binary",
               "m.inp:", "binary"}),
    [](const auto& test) { return std::string(test.param.name); });
#undef POINTS

TEST(ReadMesh, FilesThatAreNone) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(readError(folder / "missing.node"), AllOf(HasSubstr("missing.node"), HasSubstr("no such file")));
  std::ofstream(folder / "finxyz.bin") << "x";
  EXPECT_THAT(readError(folder / "fin"), HasSubstr("did you mean finxyz.bin?"));
  EXPECT_THAT(readError(""), HasSubstr("name is empty"));
  std::filesystem::create_directory(folder / "folder.node");
  EXPECT_THAT(readError(folder / "folder.node"), HasSubstr("directory"));
  EXPECT_THAT(readError(folder.write("empty.node", "")), HasSubstr("the file is empty"));
  EXPECT_THAT(readError("/dev/null"), HasSubstr("no regular file"));
}

TEST(ReadMesh, ExtensionsThatAreNotKnown) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(readError(folder.write("m.nod", "x")),
              AllOf(HasSubstr("'.nod' is no extension"), HasSubstr("did you mean '.node'"), HasSubstr(".ele")));
  EXPECT_THAT(readError(folder.write("mesh", "x")), HasSubstr("no extension"));
}

TEST(ReadMesh, FormatsThatThisBuildLeavesOutAreNamed) {
  const test::TemporaryFolder folder;
  std::string built;
  for (const MeshFormat& format : meshFormats())
    for (const std::string& extension : format.extensions) built += extension + " ";
  for (const auto& [extension, needs] : {std::pair(".vtu", "VTK"), std::pair(".poly", "TetGen")}) {
    if (built.find(extension) != std::string::npos) continue;
    EXPECT_THAT(readError(folder.write(std::string("m") + extension, "x")),
                HasSubstr(std::string("this build was made without ") + needs));
  }
  EXPECT_THAT(built, HasSubstr(".node .ele"));
}

TEST(ReadMesh, PartnerOfAPairIsMissing) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(readError(folder.write("m.node", kNode)),
              AllOf(HasSubstr("m.ele"), HasSubstr("not found beside m.node")));
  EXPECT_THAT(readError(folder.write("n.ele", kEle)), AllOf(HasSubstr("n.node"), HasSubstr("not found beside n.ele")));
}

TEST(ReadMesh, LimitOfTetrahedra) {
  const test::TemporaryFolder folder;
  folder.write("m.node", kNode);
  const auto file = folder.write("m.ele", "2 4 0\n1 1 2 3 4\n2 1 2 3 4\n");
  ReadOptions options;
  options.maxTetrahedra = 1;
  EXPECT_THAT(readError(file, options), HasSubstr("2 tetrahedra are more than the limit of 1"));
  options.maxTetrahedra = 2;
  EXPECT_EQ(readMesh(file, options).tetrahedra.size(), 2u);
}

TEST(ReadMesh, IdenticalPointsAreWeldedAndNoted) {
  const test::TemporaryFolder folder;
  folder.write("m.node", "5 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n4 -0 0 0\n");
  const TetMesh mesh = readMesh(folder.write("m.ele", "1 4 0\n0 4 1 2 3\n"));
  EXPECT_EQ(mesh.points.size(), 4u);
  EXPECT_THAT(mesh.tetrahedra, testing::ElementsAre(Tetrahedron{0, 1, 2, 3}));
  EXPECT_THAT(mesh.notes, testing::ElementsAre(HasSubstr("welded 1 points")));
}

}  // namespace
}  // namespace havs
