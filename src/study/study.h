#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/progress.h"
#include "study/axes.h"
#include "study/study_report.h"

namespace havs {

/// What is to be studied.
struct StudyRequest {
  std::string command;        ///< as typed, for the report
  std::string identity;       ///< of it what decides what is measured: a stored study goes on only with the same
  std::vector<Scene> scenes;  ///< the baseline settings on each mesh and camera; method, size, threads the same in all
  std::vector<AxisChoice> axes;
  bool effects = false;                          ///< each effect on against off (study/effect_runs.h)
  int repeat = 5;                                ///< timed drawings of each run
  std::uint64_t seed = 1;                        ///< of the order in which runs are visited
  std::size_t combinations = 24;                 ///< at most, of each subject
  std::size_t keepBytes = std::size_t{2} << 30;  ///< memory for renderers kept between visits
  std::filesystem::path folder;
  bool restart = false;  ///< forget what was measured before
};

/// Measures what is not yet in the folder's runs.jsonl, writes study.json, study.csv and images/ there, and returns
/// what they hold. Each visit is stored at once, so an interrupted study goes on where it was. Throws Error{input}
/// (scenes, meshes, folder, a study of another command or of other meshes in the folder), Error{running} (no context,
/// disk full).
StudyReport runStudy(const StudyRequest& request, const Progress& progress = {});

}  // namespace havs
