// The study as one file of HTML: the shell (src/study/page), the study as JSON, and the pictures as data URIs. They lie
// in script elements as text, so that a browser decodes a picture only when it is looked at.
#include "study/page.h"

#include <fmt/format.h>

#include <fstream>

#include "core/error.h"
#include "core/output_file.h"
#include "study/front_figure.h"
#include "study/page_pictures.h"
#include "study/page_shell.h"

namespace havs {
namespace fs = std::filesystem;
using Json = nlohmann::json;
namespace {

void check(const Json& study, const fs::path& folder) {
  const std::string file = (folder / "study.json").string();
  if (!study.is_object() || study.value("version", Json()) != 1)
    failInput("is no study of version 1", file, "was it written by 'havs study'?");
  for (const char* key : {"subjects", "axes", "runs"})
    if (!study.contains(key) || !study[key].is_array())
      failInput(fmt::format("has no list '{}'", key), file, "was it written by 'havs study'?");
}

/// Safe inside a script element: no '<', so no tag and no comment can begin in it.
std::string scriptText(std::string text) {
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) c == '<' ? safe += "\\u003c" : safe += c;
  return safe;
}

/// Safe inside an attribute in double quotes.
std::string attributeText(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '"')
      safe += "&quot;";
    else if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else
      safe += c;
  }
  return safe;
}

std::string missingNote(const PagePictures& pictures) {
  if (pictures.missing.empty()) return "";
  return fmt::format("{} pictures are not in this page, as they were not there or are no PNG files: {}{}",
                     pictures.missing.size(), pictures.missing.front(), pictures.missing.size() > 1 ? ", ..." : "");
}

std::string dataOf(const Json& study, const PagePictures& pictures) {
  std::string html = "<script type=\"application/json\" id=\"study\">";
  html += scriptText(study.dump(-1, ' ', false, Json::error_handler_t::replace)) + "</script>\n";
  for (const auto& [name, png] : pictures.png)
    html += fmt::format(
        "<script type=\"text/plain\" data-picture=\"{}\" data-reduced=\"{}\">data:image/png;base64,{}</script>\n",
        attributeText(name), pictures.reduction, base64(png));
  const std::string note = missingNote(pictures);
  if (!note.empty()) html += "<script type=\"text/plain\" id=\"missing-pictures\">" + scriptText(note) + "</script>\n";
  return html;
}

}  // namespace

bool hasStudyPage() { return true; }

StudyPage writeStudyPage(const Json& study, const fs::path& folder, std::uintmax_t mostPictureBytes) {
  check(study, folder);
  const PagePictures pictures = readPagePictures(study, folder, mostPictureBytes);
  const std::string_view shell = pageShell();
  const std::size_t place = shell.find(kPageData);
  std::string html(shell.substr(0, place));
  html += dataOf(study, pictures);
  html += shell.substr(place + kPageData.size());
  OutputFile page(folder / "report.html", ErrorKind::running);
  page.write(html);
  writeFrontFigures(study, folder);
  page.commit();
  return {html.size(), pictures.png.size(), pictures.bytes, pictures.reduction, pictures.missing};
}

StudyPage rewriteStudyPage(const fs::path& folder) {
  const fs::path file = folder / "study.json";
  std::ifstream stream(file, std::ios::binary);
  if (!stream) failInput("no study.json there", folder.string(), "name a folder that 'havs study --out' wrote");
  Json study = Json::parse(stream, nullptr, false);
  if (study.is_discarded()) failInput("is broken JSON", file.string(), "let 'havs study' write it again");
  return writeStudyPage(study, folder);
}

}  // namespace havs
