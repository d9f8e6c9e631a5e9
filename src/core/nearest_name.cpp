#include "core/nearest_name.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <vector>

namespace havs {
namespace {
std::size_t editDistance(std::string_view a, std::string_view b) {
  auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (lower(a[i]) != lower(b[j]) ? 1 : 0);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}
}  // namespace

std::string nearestName(std::string_view name, std::span<const std::string> candidates) {
  const auto nearest = std::min_element(candidates.begin(), candidates.end(), [&](const auto& a, const auto& b) {
    return editDistance(name, a) < editDistance(name, b);
  });
  return nearest == candidates.end() ? std::string{} : *nearest;
}

std::string didYouMean(std::string_view name, std::span<const std::string> candidates) {
  if (candidates.empty()) return "there is none to choose from";
  std::string text = "did you mean '" + nearestName(name, candidates) + "'? known: ";
  constexpr std::size_t kMost = 24;
  for (std::size_t i = 0; i < std::min(kMost, candidates.size()); ++i) text += (i ? ", " : "") + candidates[i];
  if (candidates.size() > kMost) text += ", ...";
  return text;
}

}  // namespace havs
