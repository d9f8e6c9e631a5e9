#pragma once
// Runs of the program that are disturbed from outside, and what must be left of them.
#include <gmock/gmock.h>

#include <chrono>
#include <set>

#include "cli/run_havs.h"
#include "cli/sample_files.h"
#include "hard/hard_case.h"

namespace havs::test {

constexpr double kHangSeconds = 120;  ///< no run of these tests needs a tenth of it, whatever else the machine does

inline std::string megabytes(std::size_t count) { return std::to_string(count) + " MB"; }

inline double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Looks again and again until `holds()`; false where it has not within kHangSeconds.
template <class Condition>
bool waitUntil(const Condition& holds) {
  for (const auto start = std::chrono::steady_clock::now(); secondsSince(start) < kHangSeconds; usleep(500))
    if (holds()) return true;
  return false;
}

/// The first child process of a process; 0: it has none.
inline pid_t childOf(pid_t process) {
  const std::string id = std::to_string(process);
  const std::string children = contentOf("/proc/" + id + "/task/" + id + "/children");
  return children.empty() ? 0 : std::stoi(children);
}

/// For a run whose drivers leave memory behind and are then unloaded: the leak sanitizer cannot tell whose it was.
inline void doNotLookForLeaks() { setenv("ASAN_OPTIONS", "detect_leaks=0", 1); }

/// Whether it still does anything: one that has ended may wait for its parent to ask.
inline bool isRunning(pid_t process) {
  const std::string stat = contentOf("/proc/" + std::to_string(process) + "/stat");
  const std::size_t name = stat.rfind(')');
  return name != std::string::npos && stat[name + 2] != 'Z' && stat[name + 2] != 'X';
}

/// In a folder with a small mesh, cube.node.
class TroubleTest : public HardTest {
 protected:
  TroubleTest() { writeTetgenMesh(folder, "cube", kCubeNode, kCubeEle); }

  /// Of everything in the folder but the mesh: path -> content.
  std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
      const std::string name = entry.path().lexically_relative(folder.path()).string();
      if (entry.is_regular_file() && !name.starts_with("cube.")) found[name] = contentOf(entry.path());
    }
    return found;
  }
  /// Runs to its end; one that hangs is killed: status -SIGKILL.
  Outcome run(const std::vector<std::string>& arguments, const Preparation& prepare = {}) const {
    StartedRun started(arguments, folder.path(), prepare);
    if (!waitUntil([&] { return started.hasEnded(); })) started.send(SIGKILL);
    return started.wait();
  }
  /// The picture that an undisturbed run writes, and nothing else.
  std::string undisturbed(std::vector<std::string> arguments, const std::string& extension = ".png") const {
    const std::string name = "undisturbed" + extension;
    arguments.insert(arguments.end(), {"-o", name});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    std::string picture = contentOf(folder / name);
    std::filesystem::remove(folder / name);
    EXPECT_FALSE(picture.empty());
    return picture;
  }
  /// "havs: ..." in one line that ends with what to try: counted where it is not so.
  static bool isMessage(const std::string& error) {
    return error.starts_with("havs: ") && error.find('\n') == error.size() - 1;
  }

  TemporaryFolder folder;
};

}  // namespace havs::test
