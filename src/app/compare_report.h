#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "image/axis.h"
#include "image/compare.h"

namespace havs {

/// Two picture files compared, and what was made of it.
struct CompareReport {
  std::filesystem::path picture, truth;
  int width = 0, height = 0;
  Comparison comparison;
  std::optional<Comparison> withMasked;  ///< where a mask was given: the pixels that it leaves out counted too
  std::vector<std::string> notes;
  std::filesystem::path difference;  ///< empty: not written
  Axis differenceAxis;
};

/// Keys as in docs/01-start.md; what is infinite or not a number becomes null.
nlohmann::ordered_json reportAsJson(const CompareReport& report);

std::string reportAsText(const CompareReport& report);

}  // namespace havs
