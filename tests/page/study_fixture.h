#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace havs::test {

/// A made study of two subjects and 60 runs, as `havs study` writes it: every axis, combined settings, the paper's
/// choice, the default; one run with an error of exactly 0, one that failed, some of another picture size; three
/// effects of each subject (effectsFixture). Writes
/// study.json and small PNG files into `folder` and returns the study.
nlohmann::json writeStudyFixture(const std::filesystem::path& folder);

/// Lighting added (2.5 times the time), clipping left out (half), shadows that failed.
nlohmann::json effectsFixture(const nlohmann::json& runs, const std::string& subject);

}  // namespace havs::test
