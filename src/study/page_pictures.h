#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace havs {

/// The pictures of a study, as bytes of PNG files.
struct PagePictures {
  std::map<std::string, std::string> png;  ///< by the name that study.json gives them
  std::vector<std::string> missing;
  std::uintmax_t bytes = 0;
  int reduction = 1;
};

/// Reads all pictures that `study` names, from `folder`. Only PNG files inside `folder` are taken; others count as
/// missing. Together they hold at most about `mostBytes`: else all are made smaller, to 1/2, 1/3, ... 1/8
/// of their width and height.
PagePictures readPagePictures(const nlohmann::json& study, const std::filesystem::path& folder,
                              std::uintmax_t mostBytes);

/// A PNG at 1/factor of its width and height, pixels averaged (colour weighted by opacity). The same bytes where it
/// cannot be decoded.
std::string reducedPng(const std::string& png, int factor);

/// Base 64 (RFC 4648), with padding.
std::string base64(const std::string& bytes);

}  // namespace havs
