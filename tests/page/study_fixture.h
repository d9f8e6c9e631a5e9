#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>

namespace havs::test {

/// A made study of two subjects and 60 runs, as `havs study` writes it: every axis, combined settings, the paper's
/// choice, the default; one run with an error of exactly 0, one that failed, some of another picture size. Writes
/// study.json and small PNG files into `folder` and returns the study.
nlohmann::json writeStudyFixture(const std::filesystem::path& folder);

}  // namespace havs::test
