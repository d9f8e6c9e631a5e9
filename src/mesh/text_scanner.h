#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace havs {

/// Walks through a text file line by line and number by number, and knows where it is when something is wrong.
/// Comments (from # to the end of the line) and lines with nothing else are passed over. Spaces, tabs and commas
/// separate.
class TextScanner {
 public:
  /// Reads the whole file. Throws Error{input} when it cannot be read or is binary.
  explicit TextScanner(const std::filesystem::path& file);

  /// Goes to the next line that holds something; false at the end of the file.
  bool nextLine();
  /// As nextLine, but throws Error{input} at the end of the file: "the file ends, but WANTED should follow".
  void needLine(std::string_view wanted);
  /// Whether the line holds more.
  bool more();
  /// The next word of the line. Throws Error{input} when there is none: "WANTED is missing".
  std::string_view word(std::string_view wanted);
  /// The next number of the line; "nan" and "inf" are numbers. Throws Error{input} when it is missing or no number.
  double real(std::string_view wanted);
  std::int64_t integer(std::string_view wanted);
  /// The whole next line, commas and # included, without blanks at either end; it may be empty. For names.
  /// Throws Error{input} at the end of the file.
  std::string_view wholeLine(std::string_view wanted);

  /// An integer that announces `wanted`, each taking at least `bytesEach` bytes of what follows: throws Error{input}
  /// when it is negative or more than the rest of the file can hold, so that no memory is taken for an empty promise.
  std::size_t count(std::string_view wanted, std::size_t bytesEach);

  /// Throws Error{input} with this file and line.
  [[noreturn]] void fail(const std::string& what, const std::string& tryThis = "") const;

  std::size_t line() const { return line_; }
  std::string place() const;

 private:
  void skipSeparators();

  std::string file_;
  std::string text_;
  const char* at_ = nullptr;
  const char* end_ = nullptr;
  std::size_t line_ = 0;
  bool inLine_ = false;
};

}  // namespace havs
