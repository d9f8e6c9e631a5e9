#include "core/stopping.h"

#include <algorithm>
#include <set>
#include <vector>

namespace havs {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostNames = 8;

struct Notes {
  std::mutex mutex;
  std::set<fs::path> temporaries;
  std::vector<fs::path> written;
  std::string kept;
};

/// Never destroyed: a signal may come while the program's end destroys what is static.
Notes& notes() {
  static Notes& all = *new Notes;
  return all;
}

std::string listOf(const std::vector<fs::path>& files) {
  if (files.empty()) return "nothing was written";
  std::string text = "written whole: ";
  for (std::size_t i = 0; i < std::min(files.size(), kMostNames); ++i) text += (i > 0 ? ", " : "") + files[i].string();
  if (files.size() > kMostNames) text += " and " + std::to_string(files.size() - kMostNames) + " more";
  return text;
}

}  // namespace

StopDelay::StopDelay() : lock_(notes().mutex) {}

void noteTemporary(const StopDelay&, const fs::path& file) { notes().temporaries.insert(file); }

void noteTemporaryGone(const StopDelay&, const fs::path& file) { notes().temporaries.erase(file); }

void noteWritten(const StopDelay&, const fs::path& file) { notes().written.push_back(file); }

void noteKept(const std::string& text) {
  const StopDelay delay;
  notes().kept = text;
}

std::string stopProcess() {
  Notes& all = notes();
  all.mutex.lock();  // and never unlocked
  std::error_code ignored;
  for (const fs::path& file : all.temporaries) fs::remove(file, ignored);
  return all.kept.empty() ? listOf(all.written) : all.kept;
}

}  // namespace havs
