// Memory, threads, open files and bytes on disk that are not to be had.
#include <sys/mount.h>
#include <sys/syscall.h>

#include <fstream>

#include "core/sanitized.h"
#include "hard/denied_calls.h"
#include "hard/trouble.h"

namespace havs::test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

/// A limit of the process, for good.
Preparation limited(decltype(RLIMIT_AS) what, std::size_t value) {
  return [=] {
    const rlimit limit{value, value};
    setrlimit(what, &limit);
  };
}

class Limits : public TroubleTest {
 protected:
  struct Count {
    int done = 0, refused = 0;
  };
  /// Either the right file and status 0, or none, status 1 and a message.
  void expectDoneOrTold(const std::vector<std::string>& arguments, const std::string& file, const std::string& whole,
                        const Preparation& prepare, Count& count) {
    const Outcome outcome = run(arguments, prepare);
    const auto left = files();
    wrong_ += left.size() != (outcome.status == 0 ? 1u : 0u) || (outcome.status == 0 && left.at(file) != whole);
    const bool told = outcome.status == 1 && outcome.error.find("havs: ") != std::string::npos &&
                      outcome.error.find("; ") != std::string::npos;
    untold_ += outcome.status != 0 && !told;
    EXPECT_TRUE(outcome.status == 0 || told) << outcome.status << ": " << outcome.error;
    (outcome.status == 0 ? count.done : count.refused) += 1;
    for (const auto& [name, content] : left) std::filesystem::remove(folder / name);
  }
  void expectNoneWrong() {
    expectAtMost("ends without a message", untold_, 0);
    expectAtMost("wrong or half files", wrong_, 0);
  }

 private:
  int untold_ = 0, wrong_ = 0;
};

#ifndef HAVS_SANITIZED
class OutOfMemory : public Limits {
 protected:
  /// With the address space limited to `sizes` (MB); the first must be too little, the last enough.
  void expectAtEachSize(const std::vector<std::string>& arguments, const std::string& file, const std::string& whole,
                        const std::vector<std::size_t>& sizes) {
    for (const std::size_t size : sizes) {
      SCOPED_TRACE(megabytes(size));
      Count count;
      expectDoneOrTold(arguments, file, whole, limited(RLIMIT_AS, size << 20), count);
      if (size == sizes.back()) {
        EXPECT_EQ(count.done, 1);
      }
    }
    expectNoneWrong();
  }
  std::vector<std::string> render(const std::string& device, const std::string& table) const {
    return {"render", "cube.node", "--size", "64x64", "--table", table, "--quiet", "--device", device};
  }
  void expectRender(const std::string& device, const std::string& table, const std::vector<std::size_t>& sizes) {
    std::vector<std::string> arguments = render(device, table);
    const std::string whole = undisturbed(arguments);
    arguments.insert(arguments.end(), {"-o", "a.png"});
    expectAtEachSize(arguments, "a.png", whole, sizes);
  }
};

TEST_F(OutOfMemory, NativeDevice) {
  tell({"Trouble while running",
        "std::bad_alloc on a thread of oneTBB, or a thread that gets no stack, ends a program by "
        "abort()",
        "whatever is thrown on a thread comes to the main one and becomes a message that says what to raise"});
  expectRender("native", "128", {42, 44, 46, 48, 50, 52, 54, 56, 60, 70, 100, 140, 200, 400, 64000});
}

TEST_F(OutOfMemory, OpenGl) {
  tell({"Trouble while running",
        "Mesa does not ask whether it got its memory: havs ended with a segmentation fault under "
        "8 of 36 limits from 205 to 555 MB",
        "a crash under a limit of memory is told as what it is, status 1; OpenGL's own error is a message, too"});
  expectRender("osmesa", "64", {60, 150, 210, 230, 250, 270, 290, 330, 390, 400, 410, 450, 470, 520, 64000});
}

#if HAVS_WITH_TETGEN
TEST_F(OutOfMemory, TetgensProcess) {
  tell({"Trouble while running", "TetGen frees what it never got",
        "it works in a process of its own; how that one ends becomes a message"});
  const std::vector<std::string> arguments{
      "mesh", HAVS_MESHES "/bracket.poly", "--tetgen", "pq1.4a0.0005", "-o", "a.node", "--quiet"};
  ASSERT_EQ(run(arguments).status, 0);
  const std::string whole = files()["a.node"];
  std::filesystem::remove(folder / "a.node");
  std::filesystem::remove(folder / "a.ele");
  int wrong = 0, refused = 0;
  for (const std::size_t size : {40, 44, 48, 52, 56, 60, 64, 70, 80, 100, 64000}) {
    const Outcome outcome = run(arguments, limited(RLIMIT_AS, size << 20));
    EXPECT_TRUE(outcome.status == 0 || isMessage(outcome.error)) << outcome.error;
    wrong += outcome.status == 0 ? files()["a.node"] != whole : outcome.status != 1 || !files().empty();
    refused += outcome.status != 0;
    for (const auto& [name, content] : files()) std::filesystem::remove(folder / name);
  }
  EXPECT_GE(refused, 1);
  expectAtMost("wrong ends", wrong, 0);
}
#endif

#if HAVS_WITH_VTK
TEST_F(OutOfMemory, VtksProcess) {
  tell({"Trouble while running",
        "VTK is a hundred libraries; where they do not fit, the advice was to look for the module, which is there",
        "the linker's words are read: where it is memory, that is what the message asks for"});
  const std::vector<std::string> arguments{"mesh", "cube.node", "-o", "a.vtu", "--quiet"};
  ASSERT_EQ(run(arguments).status, 0);
  const std::string whole = files()["a.vtu"];
  std::filesystem::remove(folder / "a.vtu");
  expectAtEachSize(arguments, "a.vtu", whole, {60, 100, 140, 160, 170, 180, 190, 200, 300, 64000});
  EXPECT_THAT(run(arguments, limited(RLIMIT_AS, 80 << 20)).error, HasSubstr("raise the limits (ulimit -v, -n)"));
}
#endif

TEST_F(OutOfMemory, Study) {
  tell({"Trouble while running", "a setting that needs more memory than there is ends a sweep of hours",
        "it is recorded as one that cannot be drawn, and the others are measured"});
  const std::vector<std::string> arguments{"study",          "cube.node", "--out",       "out",      "--size",
                                           "16x16",          "--axis",    "table=8,512", "--repeat", "1",
                                           "--combinations", "0",         "--quiet"};
  int wrong = 0;
  for (const std::size_t size : {60, 80, 120, 400}) {
    const Outcome outcome = run(arguments, limited(RLIMIT_AS, size << 20));
    EXPECT_TRUE(outcome.status == 0 || isMessage(outcome.error)) << outcome.status << outcome.error;
    wrong += outcome.status != 0 && outcome.status != 1;
    std::filesystem::remove_all(folder / "out");
  }
  expectAtMost("wrong ends", wrong, 0);
}
#endif

TEST_F(Limits, NoMoreThreads) {
  tell({"Trouble while running",
        "oneTBB throws where it cannot start a thread, Mesa goes on without one, std::thread ends "
        "the program",
        "told, with --threads 1, which needs none on the native device"});
  for (const std::string device : {"native", "osmesa"}) {
    std::vector<std::string> arguments{"render", "cube.node", "--size", "64x64",  "--table",
                                       "32",     "--device",  device,   "--quiet"};
    const std::string whole = undisturbed(arguments);
    arguments.insert(arguments.end(), {"-o", "a.png"});
    Count all, one;
    expectDoneOrTold(arguments, "a.png", whole, denyThreads, all);
    arguments.insert(arguments.end(), {"--threads", "1"});
    expectDoneOrTold(arguments, "a.png", whole, denyThreads, one);
    if (device == "native") {
      EXPECT_EQ(one.done, 1);
    }
  }
  expectNoneWrong();
}

TEST_F(Limits, FewOpenFiles) {
  tell({"Trouble while running",
        "each library, mesh and picture is an open file, and their number is limited (ulimit -n)",
        "what cannot be opened is told with the system's reason"});
  for (const std::string device : {"native", "osmesa"}) {
    std::vector<std::string> arguments{"render", "cube.node", "--size", "64x64",  "--table",
                                       "16",     "--device",  device,   "--quiet"};
    const std::string whole = undisturbed(arguments);
    arguments.insert(arguments.end(), {"-o", "a.png"});
    Count count;
    for (const std::size_t most : {4, 5, 6, 7, 8, 10, 12}) {
      SCOPED_TRACE(most);
      const Preparation limit = limited(RLIMIT_NOFILE, most);
      const Outcome outcome = run(arguments, [&] {
        closefrom(STDERR_FILENO + 1);  // of the test's own
        limit();
      });
      EXPECT_EQ(outcome.status == 0, files()["a.png"] == whole);
      EXPECT_TRUE(outcome.status >= 0 && outcome.status <= 2) << outcome.status << outcome.error;
      count.done += outcome.status == 0;
      std::filesystem::remove(folder / "a.png");
    }
    EXPECT_GE(count.done, 1);
    for (const std::size_t most : {20, 64})
      expectDoneOrTold(arguments, "a.png", whole, limited(RLIMIT_NOFILE, most), count);
  }
  expectNoneWrong();
}

TEST_F(Limits, BytesOnDisk) {
  tell({"Trouble while running", "beyond the limit of a file's size (ulimit -f) the kernel ends the process (SIGXFSZ)",
        "the signal is ignored, so that writing fails as on a full disk: a message, no half file, the older one kept"});
  for (const std::string file : {"a.png", "a.exr", "a.pfm"}) {
    std::vector<std::string> arguments{"render", "cube.node", "--size", "64x64", "--table", "16", "--quiet"};
    const std::string whole = undisturbed(arguments, std::filesystem::path(file).extension());
    arguments.insert(arguments.end(), {"-o", file});
    Count count;
    for (int tenth = 1; tenth <= 10; ++tenth)
      expectDoneOrTold(arguments, file, whole, limited(RLIMIT_FSIZE, whole.size() * tenth / 10), count);
    EXPECT_EQ(count.done, 1);
    EXPECT_EQ(count.refused, 9);
    folder.write(file, "older");
    EXPECT_EQ(run(arguments, limited(RLIMIT_FSIZE, whole.size() / 2)).status, 1);
    EXPECT_EQ(files()[file], "older");
    std::filesystem::remove(folder / file);
  }
  expectNoneWrong();
}

TEST_F(Limits, TinyDisk) {
  tell({"Trouble while running", "a disk that is full in the middle of a file",
        "a message, and nothing of the file; what was written before is whole"});
  const std::filesystem::path disk = folder / "disk";
  std::filesystem::create_directory(disk);
  // In a namespace of the run's own, where everybody may mount.
  const auto mounted = [&] {
    const std::string user = std::to_string(getuid()), group = std::to_string(getgid());
    if (unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) _exit(124);
    std::ofstream("/proc/self/setgroups") << "deny";
    std::ofstream("/proc/self/uid_map") << "0 " + user + " 1";
    std::ofstream("/proc/self/gid_map") << "0 " + group + " 1";
    if (mount("none", disk.c_str(), "tmpfs", 0, "size=64k") != 0) _exit(124);
  };
  int wrong = 0;
  for (const auto& [name, status] : std::map<std::string, int>{{"small.png", 0}, {"large.pfm", 1}, {"large.exr", 1}}) {
    const std::string size = status == 0 ? "16x16" : "300x300";
    const Outcome outcome =
        run({"render", "cube.node", "--size", size, "--table", "16", "--background", "none", "-o", "disk/" + name},
            mounted);
    if (outcome.status == 124) GTEST_SKIP() << "nobody may mount here";
    wrong += outcome.status != status;
    EXPECT_EQ(outcome.status, status) << outcome.error;
    if (status == 1) {
      EXPECT_THAT(outcome.error, HasSubstr("No space left on device; is the disk full?"));
    }
  }
  const Outcome study = run({"study", "cube.node", "--size", "64x64", "--axis", "table=8,16", "--repeat", "1",
                             "--combinations", "0", "--out", "disk/out", "--quiet"},
                            mounted);
  EXPECT_THAT(study.error, HasSubstr("No space left on device; is the disk full?"));
  wrong += study.status != 1;
  expectAtMost("wrong ends", wrong, 0);
}

}  // namespace
}  // namespace havs::test
