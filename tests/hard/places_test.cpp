// Folders that may not be written, vanish or change while the program works, and surroundings that are not as usual.
#include <linux/capability.h>
#include <sys/prctl.h>

#include <fstream>

#include "hard/trouble.h"

namespace havs::test {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

/// Rights of files count for root, too (CAP_DAC_OVERRIDE is what lets it by).
void obeyRights() { prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0); }

class Places : public TroubleTest {
 protected:
  Places() { fs::create_directory(folder / "out"); }

  /// Runs `render`, and `change` while it works: between the check of its output and the picture.
  Outcome renderWhile(const std::function<void()>& change, const std::string& output = "out/a.png") {
    // TetGen's process is where it is stopped: the path is checked by then, and the picture far.
    std::filesystem::copy_file(HAVS_MESHES "/cube.poly", folder / "cube.poly");
    StartedRun run({"render", "cube.poly", "--size", "32x32", "--table", "16", "-o", output}, folder.path());
    pid_t child = 0;
    EXPECT_TRUE(waitUntil([&] { return (child = childOf(run.process())) != 0 || run.hasEnded(); }));
    run.send(SIGSTOP);
    const bool early = !fs::exists(folder / output) && !run.hasEnded();
    change();
    run.send(SIGCONT);
    EXPECT_TRUE(early) << "it has ended before it could be disturbed";
    if (!waitUntil([&] { return run.hasEnded(); })) run.send(SIGKILL);
    return run.wait();
  }
};

TEST_F(Places, ReadOnlyFolder) {
  tell({"Trouble while running", "a folder that may not be written is found out after an hour of drawing",
        "every output's place is tried before the work begins: status 2"});
  fs::permissions(folder / "out", fs::perms::owner_read | fs::perms::owner_exec);
  int wrong = 0;
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"render", "cube.node", "-o", "out/a.png"},
                                             {"reference", "cube.node", "-o", "out/a.exr"},
                                             {"render", "cube.node", "--save-scene", "out/a.json"},
                                             {"mesh", "cube.node", "-o", "out/a.node"},
                                             {"study", "cube.node", "--out", "out/study"},
                                             {"study", "cube.node", "--out", "out"}}) {
    const Outcome outcome = run(arguments, obeyRights);
    EXPECT_THAT(outcome.error, HasSubstr("Permission denied")) << arguments[0];
    wrong += outcome.status != 2 || !isMessage(outcome.error);
  }
  fs::permissions(folder / "out", fs::perms::owner_all);
  expectAtMost("ends without a message", wrong, 0);
  expectAtMost("files left", static_cast<double>(files().size()), 0);
}

TEST_F(Places, WhatIsNoFileIsNotReplaced) {
  tell({"Trouble while running",
        "a file that is renamed into its place takes that of a device or a pipe: as root, of "
        "/dev/null for the whole machine",
        "what is there and is no file is refused"});
  ASSERT_EQ(mkfifo((folder / "a.png").c_str(), 0600), 0);
  fs::create_symlink("/dev/null", folder / "b.png");
  int wrong = 0;
  for (const std::string name : {"a.png", "b.png"}) {
    const Outcome outcome = run({"render", "cube.node", "--size", "16x16", "-o", name});
    EXPECT_THAT(outcome.error, HasSubstr(name + ": something is there that is no file"));
    wrong += outcome.status != 2;
  }
  EXPECT_TRUE(fs::is_fifo(folder / "a.png"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  expectAtMost("replaced", wrong, 0);
}

TEST_F(Places, ANameTooLong) {
  tell({"Trouble while running", "a name that is short enough for the file may be too long for the one beside it",
        "a file has no other name, or one cut to fit; a name that no file can have is refused before the work"});
  constexpr std::size_t kMost = 255;
  const std::string longest = std::string(kMost - 4, 'a') + ".png";
  const Outcome fits = run({"render", "cube.node", "--size", "16x16", "-o", longest});
  const Outcome again = run({"render", "cube.node", "--size", "16x16", "-o", longest});
  const Outcome refused = run({"render", "cube.node", "--size", "16x16", "-o", "a" + longest});
  EXPECT_EQ(refused.status, 2) << refused.error;
  EXPECT_THAT(refused.error, HasSubstr("File name too long"));
  EXPECT_EQ(files().size(), 1u);
  expectAtMost("status of the longest name", std::max(fits.status, again.status), 0);
}

#if HAVS_WITH_TETGEN
TEST_F(Places, FolderVanishes) {
  tell({"Trouble while running", "the folder is removed while the picture is drawn",
        "status 1, and the question whether it was; it is not made again"});
  const Outcome outcome = renderWhile([&] { fs::remove_all(folder / "out"); });
  EXPECT_THAT(outcome.error, HasSubstr("out: the output's folder does not exist"));
  EXPECT_EQ(outcome.output, "");
  expectAtMost("status - 1", std::abs(outcome.status - 1), 0);
  expectAtMost("files left", static_cast<double>(files().size()), 0);
}

TEST_F(Places, OutputBecomesADirectory) {
  tell({"Trouble while running", "a folder takes the picture's place while it is drawn", "status 1; the folder stays"});
  const Outcome outcome = renderWhile([&] { fs::create_directory(folder / "out/a.png"); });
  EXPECT_THAT(outcome.error, HasSubstr("out/a.png: the output is a directory"));
  EXPECT_TRUE(fs::is_directory(folder / "out/a.png"));
  expectAtMost("status - 1", std::abs(outcome.status - 1), 0);
  expectAtMost("files left", static_cast<double>(files().size()), 0);
}

TEST_F(Places, MeshVanishes) {
  tell({"Trouble while running", "the mesh is removed while it is worked on",
        "it is read once, and the picture is that of what was read"});
  const std::string whole = undisturbed({"render", HAVS_MESHES "/cube.poly", "--size", "32x32", "--table", "16"});
  const Outcome outcome = renderWhile([&] { fs::remove(folder / "cube.poly"); }, "a.png");
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  expectAtMost("pictures that differ", files()["a.png"] == whole ? 0 : 1, 0);
}
#endif

TEST_F(Places, HomeAndTemporaryFolder) {
  tell({"Trouble while running",
        "services run without HOME, containers with one that cannot be written; Mesa keeps "
        "compiled shaders there",
        "nothing is kept outside the outputs; Mesa goes on without its cache"});
  const fs::path locked = folder / "locked";
  fs::create_directory(locked);
  fs::permissions(locked, fs::perms::owner_read | fs::perms::owner_exec);
  int wrong = 0;
  doNotLookForLeaks();
  for (const std::string device : {"native", "osmesa", "egl"}) {
    std::vector<std::string> arguments{"render", "cube.node", "--size", "32x32", "--table", "16", "--device", device};
    const std::string whole = undisturbed(arguments);
    arguments.insert(arguments.end(), {"-o", "a.png"});
    for (const std::string place : {"", "/nowhere/at/all", "/dev/null", locked.c_str()}) {
      const Outcome outcome = run(arguments, [&] {
        for (const char* name : {"HOME", "TMPDIR", "XDG_CACHE_HOME", "XDG_RUNTIME_DIR"}) {
          if (place.empty())
            unsetenv(name);
          else
            setenv(name, place.c_str(), 1);
        }
        obeyRights();
      });
      EXPECT_EQ(outcome.status, 0) << device << " " << place << ": " << outcome.error;
      wrong += outcome.status != 0 || files()["a.png"] != whole;
      fs::remove(folder / "a.png");
    }
  }
  fs::permissions(locked, fs::perms::owner_all);
  expectAtMost("pictures that differ", wrong, 0);
  expectAtMost("files left", static_cast<double>(files().size()), 0);
}

TEST_F(Places, LanguageAndTimeZone) {
  tell({"Trouble while running", "where 0,5 is a half, strtod and printf misread and miswrite every number",
        "no number goes through the locale: pictures, reports, meshes and messages are the same in every language and "
        "time zone"});
  int wrong = 0;
  const auto outputsOf = [&](const std::string& language, const std::string& zone) {
    std::string all;
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"render", "cube.node", "--size", "32x32", "--table", "16", "--camera", "12.5,7.25,1.5", "-o", "a.png",
              "--save-scene", "a.json", "--quiet"},
             {"mesh", "cube.node", "--scalar", "half=0.5*x+0.25", "-o", "a.node"},
             {"info", "a.node", "--json"},
             {"render", "a.json", "--set", "camera.zoom=1.25", "-o", "b.exr", "--quiet"},
             {"render", "missing.vtu"}}) {
      const Outcome outcome = run(arguments, [&] {
        setenv("LC_ALL", language.c_str(), 1);
        setenv("LANGUAGE", language.c_str(), 1);
        setenv("TZ", zone.c_str(), 1);
      });
      all += outcome.output + outcome.error;
    }
    for (const auto& [name, content] : files()) all += name + content;
    return all;
  };
  const std::string usual = outputsOf("C", "UTC");
  EXPECT_THAT(usual, HasSubstr("0.75"));
  for (const std::string language : {"de_DE.UTF-8", "fr_FR.UTF-8", "no such language"})
    wrong += outputsOf(language, "Pacific/Kiritimati") != usual;
  expectAtMost("outputs that differ", wrong, 0);
}

}  // namespace
}  // namespace havs::test
