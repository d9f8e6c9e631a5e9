#pragma once
// Random cases in great number. By the environment:
//   HAVS_RANDOM_CASES=N      how many
//   HAVS_RANDOM_SECONDS=T    as many as T seconds of processor time allow, instead
//   HAVS_RANDOM_SEED=S       other ones; the seed is printed
//   HAVS_RANDOM_FIRST=I      the first case: with HAVS_RANDOM_CASES=1 a single one of a run again
#include <cstdint>
#include <string>
#include <vector>

#include "hard/random_check.h"

namespace havs::test {

struct RandomRun {
  std::uint64_t seed = 1;
  std::size_t first = 0;
  std::size_t cases = 0;
  double seconds = 0;  ///< > 0: instead of `cases`
  std::size_t openGl =
      50;  ///< every so many cases are drawn by one of OpenGL's ways, too: its programs are slow to make
};
/// `run` as the environment changes it.
RandomRun asAskedFor(RandomRun run);

struct FoundFailure {
  std::size_t number = 0;  ///< of the case
  std::string failure;
};

/// Checks the cases of a run. What fails is shrunk, written to random-failures/ in the build folder, and printed with
/// the command that draws it; of one kind the first three are.
std::vector<FoundFailure> runRandom(const RandomRun& run, CaseChecker& checker);

/// What was looked at, in some lines.
std::string summaryOf(const RandomTally& tally);

}  // namespace havs::test
