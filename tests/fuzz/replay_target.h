#pragma once

namespace havs::fuzz {

/// What one program of replay_test.cpp is about; replay_target.cpp is compiled for each.
struct ReplayTarget {
  const char* name;
  const char* corpus;  ///< folder
  int mutations;
};
ReplayTarget replayTarget();

}  // namespace havs::fuzz
