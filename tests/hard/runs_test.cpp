// The program itself, run twice.
#include <nlohmann/json.hpp>

#include "cli/run_havs.h"
#include "hard/like_plain.h"
#include "hard/mesh_text.h"
#include "image/image.h"

namespace havs::test {
namespace {

using Options = std::vector<std::string>;

class Runs : public HardTest {
 protected:
  struct Run {
    nlohmann::json report;
    std::string picture;  ///< the file, byte for byte
    Image image;
  };

  Run run(const std::string& mesh, const Options& options) {
    Options all{"render", mesh, "--size", "64x48", "-o", "a.pfm", "--json"};
    all.insert(all.end(), options.begin(), options.end());
    const Outcome outcome = runHavs(all, folder_.path());
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    return {nlohmann::json::parse(outcome.output), contentOf(folder_ / "a.pfm"), readImage(folder_ / "a.pfm")};
  }
  /// Without what is measured of the run.
  static nlohmann::json facts(nlohmann::json report) {
    for (const char* key : {"stages_ms", "frame_ms", "ledger", "cpu_ms", "peak_memory_bytes"}) report.erase(key);
    report["settings"].erase("threads");
    return report;
  }
  double bytesThatDiffer(const std::string& a, const std::string& b) {
    if (a.size() != b.size()) return static_cast<double>(std::max(a.size(), b.size()));
    double count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
    return count;
  }

  TemporaryFolder folder_;
};

TEST_F(Runs, TwoProcessesAndAnyThreadsGiveTheSameBytes) {
  tell({"Ties", "addresses, threads and what was in memory before differ from run to run",
        "pictures do not depend on them: files are equal byte for byte, reports but for times and memory"});
  const std::string mesh = writeNodeEle(folder_, "m", plainMesh(4)).filename().string();
  for (const Options& way :
       {Options{}, Options{"--device", "osmesa"}, Options{"--device", "osmesa", "--visibility", "abuffer"},
        Options{"--device", "osmesa", "--visibility", "cells"}, Options{"--k", "2", "--sort", "centroid"}}) {
    SCOPED_TRACE(testing::PrintToString(way));
    const Run first = run(mesh, way);
    for (const char* threads : {"0", "1", "3"}) {
      Options other = way;
      other.insert(other.end(), {"--threads", threads});
      const Run again = run(mesh, other);
      EXPECT_EQ(facts(first.report), facts(again.report));
      expectAtMost("bytes of the picture that differ", bytesThatDiffer(first.picture, again.picture), 0);
    }
  }
}

TEST_F(Runs, ReportedCameraDrawsTheSameInAnyUnit) {
  tell({"Scale and place", "a camera printed with a few digits, or fixed decimals, is another at 1e-150 or far away",
        "reports print every number to the last bit: passed back, they give the same picture"});
  for (const Units& units : {Units{.length = 1e-150}, Units{.length = 1e150}, Units{.place = Vec3(2e9, -1e9, 3e9)}}) {
    SCOPED_TRACE(units.length);
    const std::string mesh = writeNodeEle(folder_, "m", meshIn(units, plainMesh(3))).filename().string();
    const Run first = run(mesh, {"--camera", "70,-15,1.3"});
    const Run again = run(mesh, {"--camera", first.report["settings"]["camera"].dump()});
    double most = 0;
    for (std::size_t i = 0; i < first.image.rgba.size(); ++i)
      most = std::max(most, std::abs(double{first.image.rgba[i]} - double{again.image.rgba[i]}));
    expectAtMost("picture by the reported camera", most, kSameInAnyUnit);
  }
}

}  // namespace
}  // namespace havs::test
