#pragma once
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace havs {

/// What was written.
struct StudyPage {
  std::uintmax_t bytes = 0;          ///< of report.html
  std::size_t pictures = 0;          ///< in it
  std::uintmax_t pictureBytes = 0;   ///< of their PNG files as they are in it
  int reduction = 1;                 ///< pictures are in it at 1/reduction of their width and height
  std::vector<std::string> missing;  ///< pictures that study.json names and that were not there, or were no PNG
};

/// Whether this build has the page (-DHAVS_WITH_REPORT).
bool hasStudyPage();

/// Writes report.html, front.svg and front.png into `folder`, each whole or not at all. `study` is what `havs study`
/// writes as study.json; its pictures are read from `folder` and put into the page. The page opens from disk
/// and asks for nothing outside itself. Where the pictures are more than `mostPictureBytes` together they are made
/// smaller until they are not. Throws Error{input} when `study` is not of that form, Error{running} when
/// writing fails or the build has no page.
StudyPage writeStudyPage(const nlohmann::json& study, const std::filesystem::path& folder,
                         std::uintmax_t mostPictureBytes = std::uintmax_t{64} << 20);

/// Reads the study.json of `folder` and writes the page anew. Throws Error{input} when there is none or it is broken.
StudyPage rewriteStudyPage(const std::filesystem::path& folder);

}  // namespace havs
