#pragma once
#include <span>
#include <string>
#include <string_view>

namespace havs {

/// The candidate with the fewest edits (insert, delete, replace, letters' case free) from `name`; empty when there are
/// no candidates.
std::string nearestName(std::string_view name, std::span<const std::string> candidates);

/// "did you mean 'x'? known: x, y, z": the end of an error about an unknown name (at most 24 names are listed).
std::string didYouMean(std::string_view name, std::span<const std::string> candidates);

}  // namespace havs
