#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace havs::test {

/// A file of the given name and content in a folder of the running test's own, gone with the object.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& content) {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string folder = std::string("havs_") + info->test_suite_name() + "_" + info->name();
    for (char& c : folder) c = c == '/' ? '_' : c;
    folder_ = std::filesystem::path(testing::TempDir()) / folder;
    std::filesystem::create_directories(folder_);
    path_ = folder_ / name;
    std::ofstream(path_, std::ios::binary) << content;
  }
  ~TemporaryFile() { std::filesystem::remove_all(folder_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path folder_;
  std::filesystem::path path_;
};

}  // namespace havs::test
