// A fuzz target without libFuzzer: every input of its corpus, each of them cut at every byte where it is small, and
// mutations from a fixed seed.
#include <unistd.h>

#include <algorithm>

#include "core/memory.h"
#include "core/parallel.h"
#include "fuzz/fuzz.h"
#include "fuzz/mutate.h"
#include "hard/hard_case.h"
#include "support/sanitized.h"
#include "support/temporary_folder.h"

#define HAVS_TEXT(name) HAVS_TEXT_OF(name)
#define HAVS_TEXT_OF(name) #name
#define HAVS_CASE(name) TEST_F(Fuzzed, name)

namespace havs::test {
namespace {

using Fuzzed = HardTest;

constexpr int kMutations = 2000;
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
  for (const auto& entry : std::filesystem::directory_iterator(HAVS_FUZZ_CORPUS)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

HAVS_CASE(HAVS_FUZZ_TARGET) {
  tell({"Hostile input",
        "readers of " HAVS_TEXT(HAVS_FUZZ_TARGET) " meet counts, numbers and ends of file that no writer writes",
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
  for (int i = 0; i < kMutations; ++i) inputs.run(fuzz::mutated(contents, random), "mutation " + std::to_string(i));
  alarm(0);
  EXPECT_GT(inputs.tried, static_cast<std::size_t>(kMutations));
  expectAtMost("inputs neither read nor refused", static_cast<double>(inputs.wrong), 0);
  if (!kSanitized)
    expectAtMost("memory, MB", static_cast<double>(peakMemoryBytes()) / 1e6,
                 static_cast<double>(fuzz::kMemoryLimit) / 1e6);
}

}  // namespace
}  // namespace havs::test
