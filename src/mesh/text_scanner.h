#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "mesh/file_blocks.h"

namespace havs {

/// Walks through a text file line by line and number by number, and knows where it is when something is wrong.
/// Comments (from # to the end of the line) and lines with nothing else are passed over. Spaces, tabs and commas
/// separate. A byte order mark of UTF-8 before the text is passed over.
class TextScanner {
 public:
  /// Reads the whole file. Throws Error{input} when it cannot be read or is binary.
  explicit TextScanner(const std::filesystem::path& file);
  /// A scanner of whole lines of a text that another one read: `lines` is part of its rest(). Line numbers in messages
  /// begin at 1 there.
  TextScanner(const TextScanner& whole, std::string_view lines);

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
  /// Throws Error{input} where the line holds more and seems to write its numbers with decimal commas: "1 0,5 0,5 0,5".
  /// Commas separate, so the numbers were wrong.
  void refuseDecimalCommas();
  /// The next character of the line, 0 at its end.
  char peek();
  /// The whole next line, commas and # included, without blanks at either end; it may be empty. For names.
  /// Throws Error{input} at the end of the file.
  std::string_view wholeLine(std::string_view wanted);

  /// An integer that announces `wanted`, each taking at least `bytesEach` bytes of what follows: throws Error{input}
  /// when it is negative or more than the rest of the file can hold, so that no memory is taken for an empty promise.
  std::size_t count(std::string_view wanted, std::size_t bytesEach);
  /// Whether `bytes` more can follow in the file.
  bool holds(std::size_t bytes) const;

  /// Throws Error{input} with this file and line.
  [[noreturn]] void fail(const std::string& what, const std::string& tryThis = "") const;

  /// How much of the file lies behind, 0 to 1.
  double fraction() const;
  /// What nextLine() has still to go through: from the end of this line on.
  std::string_view rest() const;

 private:
  void skipSeparators();
  std::string place() const;
  template <class Number>
  bool quickly(Number& value);

  std::string file_;
  std::shared_ptr<const FileText> text_;
  const char* begin_ = nullptr;
  const char* at_ = nullptr;
  const char* end_ = nullptr;
  const char* lineBegin_ = nullptr;  // of a line that nextLine() found
  std::size_t line_ = 0;
  bool inLine_ = false;
};

}  // namespace havs
