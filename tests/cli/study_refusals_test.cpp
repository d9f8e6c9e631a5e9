// What havs study refuses, before it measures anything.
#include "cli/refused.h"

namespace havs::test {
namespace {

class StudyRefusal : public RefusedRun {};

TEST_P(StudyRefusal, IsRefused) { expectRefused(GetParam()); }

const std::vector<Refused> kRefusedStudies{
    {"NoMesh", {"study", "--out", "out"}, "INPUT"},
    {"NoFolder", {"study", "cube.node"}, "--out"},
    {"MissingMesh", {"study", "cube.node", "none.node", "--out", "out"}, "none.node"},
    {"UnknownAxis", {"study", "cube.node", "--out", "out", "--axis", "kk=1"}, "did you mean 'k'"},
    {"NoValueOfAnAxis", {"study", "cube.node", "--out", "out", "--axis", "table=large"}, "'large' is not"},
    {"EmptyValue", {"study", "cube.node", "--out", "out", "--axis", "k=1,,2"}, "--axis k"},
    {"AxisTwice", {"study", "cube.node", "--out", "out", "--axis", "k=1", "--axis", "k=2"}, "given twice"},
    {"NoRepetition", {"study", "cube.node", "--out", "out", "--repeat", "0"}, "--repeat"},
    {"NegativeCombinations", {"study", "cube.node", "--out", "out", "--combinations", "-1"}, "--combinations"},
    {"BadBaseline", {"study", "cube.node", "--out", "out", "--k", "99"}, "k is 99"},
    {"BadCamera", {"study", "cube.node", "--out", "out", "--camera", "0,0", "--camera", "up"}, "camera"},
    {"BadClipping", {"study", "cube.node", "--out", "out", "--clip-plane", "0,0,0,0,0,0"}, "normal"},
    {"FolderIsAFile", {"study", "cube.node", "--out", "cube.ele"}, "cube.ele"},
    {"FolderInAFile", {"study", "cube.node", "--out", "cube.ele/out"}, "cannot make the folder"},
    {"FolderCannotBeWritten", {"study", "cube.node", "--out", "/proc"}, "/proc"},
    {"UnknownField", {"study", "cube.node", "--out", "out", "--field", "none"}, "none"},
};

INSTANTIATE_TEST_SUITE_P(Refused, StudyRefusal, testing::ValuesIn(kRefusedStudies), nameOfCase);

/// A folder that holds another study keeps it.
class StoredStudy : public RefusedRun {};

TEST_P(StoredStudy, IsKept) {
  const std::vector<std::string> begun{"study",    "cube.node", "--out",          "out",     "--size",
                                       "8x8",      "--axis",    "k=1,2",          "--table", "4",
                                       "--repeat", "1",         "--combinations", "0",       "--quiet"};
  ASSERT_EQ(runHavs(begun, folder.path()).status, 0);
  const std::string before = contentOf(folder / "out/runs.jsonl");
  if (GetParam().name == "AnotherMesh")
    folder.write("cube.node",
                 "8 3 1 0\n0 0 0 0 7\n1 1 0 0 1\n2 0 1 0 1\n3 1 1 0 2\n4 0 0 1 1\n5 1 0 1 2\n6 0 1 1 2\n7 1 1 1 3\n");
  if (GetParam().name == "AnotherCompanion")
    folder.write("cube.ele", "5 4 1\n0 0 1 3 7 0\n1 0 3 2 7 1\n2 0 2 6 7 2\n3 0 6 4 7 3\n4 0 4 5 7 4\n");
  if (GetParam().name == "DamagedLine") folder.write("out/runs.jsonl", "{}\n" + before);
  const std::string kept = contentOf(folder / "out/runs.jsonl");
  expectRefused({GetParam().name, GetParam().arguments.empty() ? begun : GetParam().arguments, GetParam().says});
  EXPECT_EQ(contentOf(folder / "out/runs.jsonl"), kept);
}

const std::vector<Refused> kStored{
    {"AnotherCommandLine", {"study", "cube.node", "--out", "out", "--size", "8x9"}, "another command line"},
    {"AnotherMesh", {}, "another content of cube.node"},
    {"AnotherCompanion", {}, "not what was measured before"},
    {"DamagedLine", {}, "runs.jsonl:1"},
};

INSTANTIATE_TEST_SUITE_P(Stored, StoredStudy, testing::ValuesIn(kStored), nameOfCase);

}  // namespace
}  // namespace havs::test
