#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>

namespace havs {

/// Draws the fronts of a study, one panel a subject, into front.svg and front.png of `folder`: error (99.9th
/// percentile) against the wall time of a frame on logarithmic axes, the front as a stepped line, its runs numbered and
/// listed, the paper's choice and the default named. An error of exactly 0 is drawn below the others at a place of its
/// own. Throws Error{running} when writing fails.
void writeFrontFigures(const nlohmann::json& study, const std::filesystem::path& folder);

}  // namespace havs
