// havs render --max-error as a user runs it.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/refused.h"

namespace havs::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class MaxError : public testing::Test {
 protected:
  MaxError() { writeTetgenMesh(folder, "cube", kCubeNode, kCubeEle); }
  Outcome render(std::vector<std::string> more) const {
    std::vector<std::string> all{"render", "cube.node", "--size", "96x48", "-o", "a.png"};
    all.insert(all.end(), more.begin(), more.end());
    return runHavs(all, folder.path());
  }
  TemporaryFolder folder;
};

TEST_F(MaxError, ChoosesDrawsAndVerifies) {
  const Outcome run = render({"--max-error", "0.005", "--verify", "--json"});
  ASSERT_EQ(run.status, 0) << run.error;
  const json report = json::parse(run.output);
  const json& error = report["max_error"];
  EXPECT_EQ(error["asked"], 0.005);
  EXPECT_EQ(error["measure"], "p999");
  EXPECT_EQ(error["probe_size"], json({96, 48}));  // the picture is smaller than a probe may be
  EXPECT_LE(error["estimate"], 0.0025);
  EXPECT_EQ(error["true_error"], error["estimate"]);  // of the same picture
  EXPECT_GT(error["candidates"], 10);
  EXPECT_THAT(error["settings"].get<std::string>(), HasSubstr(report["settings"]["lookup"].get<std::string>()));
  EXPECT_TRUE(std::filesystem::exists(folder / "a.png"));
}

TEST_F(MaxError, TellsWhatItChose) {
  const Outcome run = render({"--max-error", "0.1", "--error-measure", "rmse"});
  ASSERT_EQ(run.status, 0) << run.error;
  EXPECT_THAT(run.output, HasSubstr("asked 0.1"));
  EXPECT_THAT(run.output, HasSubstr("(rmse)"));
  EXPECT_THAT(run.output, testing::Not(HasSubstr("verified")));
}

class MaxErrorRefusal : public RefusedRun {};

TEST_P(MaxErrorRefusal, IsRefused) { expectRefused(GetParam()); }

const std::vector<Refused> kRefusedErrors{
    {"Zero", {"render", "cube.node", "-o", "a.png", "--max-error", "0"}, "--max-error"},
    {"NotANumber", {"render", "cube.node", "-o", "a.png", "--max-error", "nan"}, "--max-error"},
    {"Word", {"render", "cube.node", "-o", "a.png", "--max-error", "small"}, "--max-error"},
    {"UnknownMeasure",
     {"render", "cube.node", "-o", "a.png", "--max-error", "0.1", "--error-measure", "rms"},
     "did you mean 'rmse'"},
    {"VerifyWithout", {"render", "cube.node", "-o", "a.png", "--verify"}, "--max-error only"},
    {"MeasureWithout", {"render", "cube.node", "-o", "a.png", "--error-measure", "rmse"}, "--max-error only"},
    {"CannotBeReached",
     {"render", "cube.node", "-o", "a.png", "--size", "48x48", "--max-error", "1e-12"},
     "the best reached",
     1},
};
INSTANTIATE_TEST_SUITE_P(Refused, MaxErrorRefusal, testing::ValuesIn(kRefusedErrors), nameOfCase);

}  // namespace
}  // namespace havs::test
