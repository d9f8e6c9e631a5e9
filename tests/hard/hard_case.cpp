#include "hard/hard_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace havs::test {

void HardTest::expectAtMost(const std::string& what, double value, double bound) {
  EXPECT_LE(value, bound) << what;
  const auto row = std::find_if(measures_.begin(), measures_.end(), [&](const auto& m) { return m.what == what; });
  if (row == measures_.end()) {
    measures_.push_back({what, value, bound});
  } else if (!(value <= row->value)) {
    *row = {what, value, bound};
  }
}

void HardTest::TearDown() {
  if (IsSkipped()) return;
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  ASSERT_FALSE(story_.group.empty() || story_.trouble.empty() || story_.remedy.empty())
      << "a hard case tells its story";
  ASSERT_FALSE(measures_.empty()) << "a hard case measures something";
  nlohmann::ordered_json row{{"group", story_.group},
                             {"case", std::string(info->test_suite_name()) + "." + info->name()},
                             {"trouble", story_.trouble},
                             {"remedy", story_.remedy},
                             {"passed", !HasFailure()}};
  for (const CaseMeasure& m : measures_)
    row["measures"].push_back({{"what", m.what}, {"value", m.value}, {"bound", m.bound}});
  const std::filesystem::path folder = std::filesystem::path(HAVS_BUILD) / "hard-cases";
  std::filesystem::create_directories(folder);
  std::string name = row["case"];
  std::replace(name.begin(), name.end(), '/', '.');
  std::ofstream(folder / (name + ".json")) << row.dump(1) << '\n';
}

}  // namespace havs::test
