#include "fuzz/replay_target.h"

namespace havs::fuzz {

ReplayTarget replayTarget() { return {HAVS_FUZZ_TARGET, HAVS_FUZZ_CORPUS, HAVS_FUZZ_MUTATIONS}; }

}  // namespace havs::fuzz
