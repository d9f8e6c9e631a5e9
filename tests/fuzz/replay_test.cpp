// A fuzz target without libFuzzer: every input of its corpus, each of them cut at every byte where it is small, and
// mutations from a fixed seed.
#include <unistd.h>

#include <algorithm>

#include "core/memory.h"
#include "core/parallel.h"
#include "fuzz/fuzz.h"
#include "fuzz/mutate.h"
#include "fuzz/replay_target.h"
#include "hard/hard_case.h"
#include "support/sanitized.h"
#include "support/temporary_folder.h"

namespace havs::test {
namespace {

constexpr std::size_t kCutEverywhere = 2048;  ///< bytes of an input
constexpr unsigned kSecondsUntilHung = 240;   ///< for all; the whole takes one or two

class Inputs {
 public:
  /// What came of them: a refusal and a result are both right.
  std::size_t tried = 0, wrong = 0;

  void run(const std::string& input, const std::string& name) {
    ++tried;
    try {
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
    } catch (const std::exception& error) {
      ++wrong;
      ADD_FAILURE() << name << ": " << error.what();
    }
  }
};

std::vector<std::filesystem::path> corpus() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(fuzz::replayTarget().corpus))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

class Fuzzed : public HardTest {
 public:
  void TestBody() override;
};

void Fuzzed::TestBody() {
  const fuzz::ReplayTarget target = fuzz::replayTarget();
  tell({"Hostile input",
        std::string("the reader of ") + target.name + " meets counts, numbers and ends that no writer writes",
        "fuzzed by libFuzzer under sanitizers; here its corpus runs, cut at every byte, and mutations of it"});
  const ThreadLimit oneThread(1);
  alarm(kSecondsUntilHung);
  Inputs inputs;
  std::vector<std::string> contents;
  for (const auto& file : corpus()) {
    contents.push_back(contentOf(file));
    inputs.run(contents.back(), file.filename().string());
  }
  ASSERT_FALSE(contents.empty());
  for (const std::string& content : contents)
    for (std::size_t end = 0; content.size() <= kCutEverywhere && end < content.size(); ++end)
      inputs.run(content.substr(0, end), "cut at byte " + std::to_string(end));
  fuzz::Random random(1);
  for (int i = 0; i < target.mutations; ++i)
    inputs.run(fuzz::mutated(contents, random), "mutation " + std::to_string(i));
  alarm(0);
  EXPECT_GT(inputs.tried, static_cast<std::size_t>(target.mutations));
  expectAtMost("inputs neither read nor refused", static_cast<double>(inputs.wrong), 0);
  if (!kSanitized)
    expectAtMost("memory, MB", static_cast<double>(peakMemoryBytes()) / 1e6,
                 static_cast<double>(fuzz::kMemoryLimit) / 1e6);
}

/// Named for the target: the name is known at run time only.
const testing::TestInfo* const kCase = testing::RegisterTest("Fuzzed", fuzz::replayTarget().name, nullptr, nullptr,
                                                             __FILE__, __LINE__, [] { return new Fuzzed; });

}  // namespace
}  // namespace havs::test
