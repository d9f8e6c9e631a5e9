#pragma once
#include <stdexcept>
#include <string>

namespace havs {

/// Whose fault it is, and so the exit status of the program.
enum class ErrorKind {
  input,   ///< the input or the command line is wrong: exit status 2
  running  ///< something failed while running (disk, memory, driver): exit status 1
};

/// The one exception of the project. `what()` is "WHERE: WHAT; TRY" on one line: what it quotes of a file may hold
/// anything, so control characters become blanks or '?', as a terminal obeys them and NUL would end the text.
class Error : public std::runtime_error {
 public:
  /// `what`: what is wrong. `where`: file and line, cell number, option; may be empty. `tryThis`: what to do; may be
  /// empty.
  Error(ErrorKind kind, const std::string& what, const std::string& where = "", const std::string& tryThis = "");
  ErrorKind kind() const { return kind_; }
  int exitStatus() const { return kind_ == ErrorKind::input ? 2 : 1; }

 private:
  ErrorKind kind_;
};

/// Throws Error{input}.
[[noreturn]] void failInput(const std::string& what, const std::string& where = "", const std::string& tryThis = "");
/// Throws Error{running}.
[[noreturn]] void failRunning(const std::string& what, const std::string& where = "", const std::string& tryThis = "");

}  // namespace havs
