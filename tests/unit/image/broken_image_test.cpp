#include <gmock/gmock.h>

#include "core/error.h"
#include "image/image.h"
#include "support/temporary_folder.h"

namespace havs {
namespace {

using testing::HasSubstr;

std::string messageOfReading(const std::filesystem::path& file) {
  try {
    readImage(file);
  } catch (const Error& error) {
    EXPECT_EQ(error.exitStatus(), 2);
    return error.what();
  }
  return "no error";
}

Image gradient() {
  Image image{64, 64, std::vector<float>(4 * 64 * 64)};
  for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = static_cast<float>(i % 251) / 251;
  return image;
}

TEST(BrokenImage, EveryCutIsNoticed) {
  test::TemporaryFolder folder;
  for (const std::string extension : {"png", "exr", "pfm"}) {
    const auto whole = folder / ("whole." + extension);
    writeImage(gradient(), whole);
    const std::string content = test::contentOf(whole);
    for (std::size_t cut = 0; cut < 20; ++cut) {
      const auto part = folder.write("part." + extension, content.substr(0, content.size() * cut / 20));
      EXPECT_NE(messageOfReading(part), "no error") << extension << " at " << cut << "/20";
    }
  }
}

/// A header that promises terabytes must be refused before memory is taken.
TEST(BrokenImage, HugeHeaderIsRefused) {
  test::TemporaryFolder folder;
  EXPECT_THAT(messageOfReading(folder.write("a.pfm", "PF\n1000000 1000000\n-1.0\nabc")), HasSubstr("cannot hold"));
  EXPECT_THAT(messageOfReading(folder.write("b.pfm", "PF\n-4 4\n-1.0\nabc")), HasSubstr("cannot hold"));
  writeImage(gradient(), folder / "a.exr");
  std::string content = test::contentOf(folder / "a.exr");
  const std::size_t window = content.find("dataWindow") + std::string("dataWindow").size() + 1 + sizeof("box2i") + 4;
  content.replace(window + 8, 8, std::string("\xff\xff\x0f\0\xff\xff\x0f\0", 8));
  EXPECT_THAT(messageOfReading(folder.write("b.exr", content)), HasSubstr("cannot hold"));
}

TEST(BrokenImage, ForeignContentIsNamed) {
  test::TemporaryFolder folder;
  for (const std::string name : {"a.png", "a.exr", "a.pfm"})
    EXPECT_THAT(messageOfReading(folder.write(name, "this is no picture at all, only text")), HasSubstr("not a"));
}

TEST(BrokenImage, MissingFileFolderAndUnknownExtension) {
  test::TemporaryFolder folder;
  EXPECT_THAT(messageOfReading(folder / "missing.png"), HasSubstr("no such file"));
  std::filesystem::create_directory(folder / "folder.png");
  EXPECT_THAT(messageOfReading(folder / "folder.png"), HasSubstr("directory"));
  EXPECT_THAT(messageOfReading(folder / "a.jpg"), HasSubstr("use .png, .exr or .pfm"));
}

TEST(CheckImagePath, RefusesWhatWriteImageWould) {
  test::TemporaryFolder folder;
  EXPECT_NO_THROW(checkImagePath(folder / "a.png"));
  EXPECT_EQ(folder.entries(), 0u);
  EXPECT_THROW(checkImagePath(folder / "a"), Error);
  EXPECT_THROW(checkImagePath(folder / "a.jpg"), Error);
  EXPECT_THROW(checkImagePath(folder / "missing/a.png"), Error);
  std::filesystem::create_directory(folder / "folder.png");
  EXPECT_THROW(checkImagePath(folder / "folder.png"), Error);
}

TEST(WriteImage, RefusesOddDepthsAndEmptyPicturesWithoutAFile) {
  test::TemporaryFolder folder;
  EXPECT_THROW(writeImage(gradient(), folder / "a.png", {Color{1, 1, 1}, 12}), Error);
  EXPECT_THROW(writeImage(Image{}, folder / "a.png"), Error);
  EXPECT_EQ(folder.entries(), 0u);
}

}  // namespace
}  // namespace havs
