#pragma once
#include <string>
#include <vector>

namespace havs {

/// Collects what VTK says while it lives, instead of VTK's printing it.
class MessageLog {
 public:
  MessageLog();
  ~MessageLog();
  MessageLog(const MessageLog&) = delete;
  MessageLog& operator=(const MessageLog&) = delete;

  /// The first error as one phrase, without VTK's file names and addresses; empty when there was none.
  std::string firstError() const;
  /// All different warnings, each as one phrase.
  std::vector<std::string> warnings() const;
};

}  // namespace havs
