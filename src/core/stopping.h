#pragma once
#include <filesystem>
#include <mutex>
#include <string>

namespace havs {

/// Holds off stopProcess() while it lives: around steps that must happen all or not at all. Not to be nested.
class StopDelay {
 public:
  StopDelay();

 private:
  std::unique_lock<std::mutex> lock_;
};

/// What a stopped process must know. Each is called with a StopDelay alive, so that no stop comes between a step and
/// its note. Temporary files are removed by a stop; `file` written whole and `text` kept are told by it.
void noteTemporary(const StopDelay&, const std::filesystem::path& file);
void noteTemporaryGone(const StopDelay&, const std::filesystem::path& file);
void noteWritten(const StopDelay&, const std::filesystem::path& file);

/// What work that can go on has kept, and how: it is told instead of the files.
void noteKept(const std::string& text);

/// For good: no step that a StopDelay guards is begun any more, temporary files are removed. Returns what the user
/// has: "written whole: a.png, b.exr", "nothing was written", or the text of noteKept().
std::string stopProcess();

}  // namespace havs
