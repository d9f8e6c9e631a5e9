#pragma once
#include <gmock/gmock.h>

#include <set>
#include <string>
#include <vector>

#include "cli/run_havs.h"
#include "cli/sample_files.h"

namespace havs::test {

/// A command line that must be refused, and a part of the reason.
struct Refused {
  std::string name;  ///< of the case
  std::vector<std::string> arguments;
  std::string says;
  int status = 2;
};

inline void PrintTo(const Refused& refused, std::ostream* stream) {
  for (const std::string& argument : refused.arguments) *stream << argument << ' ';
}

inline std::string nameOfCase(const testing::TestParamInfo<Refused>& info) { return info.param.name; }

inline std::set<std::filesystem::path> contentsOf(const std::filesystem::path& folder) {
  return {std::filesystem::recursive_directory_iterator(folder), std::filesystem::recursive_directory_iterator()};
}

/// A folder with a sound mesh, cube.node and cube.ele.
class RefusedRun : public testing::TestWithParam<Refused> {
 protected:
  RefusedRun() { writeTetgenMesh(folder, "cube", kCubeNode, kCubeEle); }

  /// The exit status, one line with the reason, nothing printed, and no file more than before.
  void expectRefused(const Refused& refused, const Preparation& prepare = {}) {
    const auto before = contentsOf(folder.path());
    const Outcome run = runHavs(refused.arguments, folder.path(), prepare);
    EXPECT_EQ(run.status, refused.status) << run.error;
    EXPECT_EQ(run.output, "");
    EXPECT_THAT(run.error, testing::StartsWith("havs: "));
    EXPECT_THAT(run.error, testing::HasSubstr(refused.says));
    EXPECT_EQ(run.error.find('\n'), run.error.size() - 1) << "not one line: " << run.error;
    EXPECT_EQ(contentsOf(folder.path()), before);
  }

  TemporaryFolder folder;
};

}  // namespace havs::test
