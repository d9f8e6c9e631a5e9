#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/nearest_name.h"
#include "core/text_file.h"
#include "transfer/transfer_files.h"

namespace havs {
namespace {

bool isXml(std::string_view content) {
  const std::size_t first = content.find_first_not_of(" \t\r\n");
  return content.starts_with("\xef\xbb\xbf<") || (first != std::string_view::npos && content[first] == '<');
}

/// The format shows in the content; only the table of raw floats has no mark but its size and is known by its name,
/// too.
TransferFunction readByContent(std::string_view content, const std::filesystem::path& path) {
  const std::string file = path.string();
  if (content.empty()) failInput("is empty", file);
  if (path.extension() == ".bin" || content.size() == kTableBytes) return readTransferTable(content, file);
  if (isXml(content)) return readParaViewXml(content, file);
  return isParaViewJson(content, file) ? readParaViewJson(content, file) : readTransferJson(content, file);
}

TransferFunction loadFile(const std::filesystem::path& path) {
  TransferFunction function = readByContent(readTextFile(path), path);
  if (function.name.empty()) function.name = path.stem().string();
  return function;
}

std::vector<std::string> presetNames() {
  std::vector<std::string> names;
  for (const TransferPreset& preset : transferPresets()) names.push_back(preset.name);
  return names;
}

}  // namespace

TransferFunction loadTransferFunction(const std::string& presetOrFile) {
  for (const TransferPreset& preset : transferPresets()) {
    if (preset.name == presetOrFile) return preset.function;
  }
  if (std::filesystem::exists(presetOrFile)) return loadFile(presetOrFile);
  if (presetOrFile.find_first_of("./\\") != std::string::npos)
    failInput("no such file", presetOrFile, "name a file or one of the presets");
  failInput("neither a preset nor a file", fmt::format("transfer function '{}'", presetOrFile),
            didYouMean(presetOrFile, presetNames()));
}

}  // namespace havs
