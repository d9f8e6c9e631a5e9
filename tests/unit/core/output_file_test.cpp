#include "core/output_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/error.h"
#include "support/temporary_folder.h"

namespace havs {
namespace {

class OutputFileTest : public testing::Test {
 protected:
  test::TemporaryFolder folder;
};

TEST_F(OutputFileTest, AppearsOnCommitOnly) {
  {
    OutputFile file(folder / "a.txt");
    file.write("content");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
    file.commit();
  }
  EXPECT_EQ(test::contentOf(folder / "a.txt"), "content");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST_F(OutputFileTest, LeavesNothingWithoutCommit) {
  { OutputFile(folder / "a.txt").write("content"); }
  EXPECT_EQ(folder.entries(), 0u);
}

TEST_F(OutputFileTest, OldContentStaysUntilCommit) {
  folder.write("a.txt", "old");
  { OutputFile(folder / "a.txt").write("new"); }
  EXPECT_EQ(test::contentOf(folder / "a.txt"), "old");
  OutputFile file(folder / "a.txt");
  file.write("new");
  file.commit();
  EXPECT_EQ(test::contentOf(folder / "a.txt"), "new");
}

TEST_F(OutputFileTest, TemporaryKeepsTheExtension) {
  OutputFile file(folder / "a.vtu");
  EXPECT_EQ(file.temporary().extension(), ".vtu");
  EXPECT_EQ(file.temporary().parent_path(), folder.path());
}

TEST_F(OutputFileTest, RefusesFoldersAndMissingFolders) {
  EXPECT_THROW(OutputFile(folder.path()), Error);
  EXPECT_THROW(OutputFile(folder / "missing/a.txt"), Error);
  EXPECT_THROW(OutputFile(folder.path() / ""), Error);
}

TEST_F(OutputFileTest, RefusesAFolderThatCannotBeWritten) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_THROW(OutputFile(folder / "a.txt"), Error);
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
}

}  // namespace
}  // namespace havs
