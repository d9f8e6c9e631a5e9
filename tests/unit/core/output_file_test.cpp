#include "core/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <set>

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

TEST_F(OutputFileTest, IsWrittenByItsTemporaryNameToo) {
  OutputFile file(folder / "a.vtu");
  std::ofstream(file.temporary()) << "first, and longer";
  std::ofstream(file.temporary()) << "second";
  file.commit();
  EXPECT_EQ(test::contentOf(folder / "a.vtu"), "second");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST_F(OutputFileTest, SeveralOfOneNameTakeTurns) {
  OutputFile first(folder / "a.txt"), second(folder / "a.txt");
  first.write("first");
  second.write("second");
  second.commit();
  EXPECT_EQ(test::contentOf(folder / "a.txt"), "second");
  first.commit();
  EXPECT_EQ(test::contentOf(folder / "a.txt"), "first");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST_F(OutputFileTest, RemovesWhatADeadProcessLeftAndNothingElse) {
  folder.write(".a.txt.havs-1-0", "of a process that is dead");
  folder.write(".b.txt.havs-1-0", "of another file");
  folder.write(".a.txt", "of somebody else");
  const int locked = open(folder.write(".a.txt.havs-2-0", "of a process that writes").c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(flock(locked, LOCK_EX), 0);
  { OutputFile(folder / "a.txt").commit(); }
  close(locked);
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) names.insert(entry.path().filename());
  EXPECT_EQ(names, (std::set<std::string>{".a.txt", ".a.txt.havs-2-0", ".b.txt.havs-1-0", "a.txt"}));
}

TEST_F(OutputFileTest, WhatWasTriedBeforeFailsWhileRunning) {
  try {
    OutputFile(folder / "missing/a.txt", ErrorKind::running);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::running);
  }
}

TEST_F(OutputFileTest, FailsWhereItsFolderHasGone) {
  std::filesystem::create_directory(folder / "b");
  OutputFile file(folder / "b/a.txt");
  file.write("content");
  std::filesystem::remove_all(folder / "b");
  EXPECT_THROW(file.commit(), Error);
  EXPECT_EQ(folder.entries(), 0u);
}

TEST_F(OutputFileTest, RefusesFoldersAndMissingFolders) {
  EXPECT_THROW(OutputFile(folder.path()), Error);
  EXPECT_THROW(OutputFile(folder / "missing/a.txt"), Error);
  EXPECT_THROW(OutputFile(folder.path() / ""), Error);
}

// One that takes no files from anybody; rights bind no root (tests/hard/places_test.cpp takes its powers away).
TEST_F(OutputFileTest, RefusesAFolderThatCannotBeWritten) { EXPECT_THROW(OutputFile("/proc/a.txt"), Error); }

}  // namespace
}  // namespace havs
