#include "core/text_file.h"

#include <fstream>
#include <iterator>

#include "core/error.h"

namespace havs {

std::string readTextFile(const std::filesystem::path& file) {
  constexpr std::uintmax_t kLargestFile = std::uintmax_t{64} << 20;
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) failInput("cannot be read: no such file", file.string(), "check the path");
  if (std::filesystem::is_directory(status)) failInput("is a directory", file.string(), "name a file in it");
  if (!std::filesystem::is_regular_file(status)) failInput("is no regular file", file.string(), "name another");
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) failInput("cannot be read: " + error.message(), file.string());
  if (size > kLargestFile) failInput("is larger than 64 MiB, more than any such file", file.string(), "is it another?");
  std::ifstream stream(file, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) failInput("cannot be read", file.string(), "check its permissions");
  return content;
}

}  // namespace havs
