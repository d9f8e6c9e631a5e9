#pragma once
#include <functional>

#include "core/progress.h"
#include "mesh/text_scanner.h"

namespace havs {

/// The lines of a table of TetGen's, each with its number first, one after the other from 0 or from 1.
struct NumberedRows {
  std::size_t count = 0;
  bool inOrder = false;     ///< by one thread, each row after the one before
  const char* one = "";     ///< "point"
  const char* many = "";    ///< "points"
  const char* number = "";  ///< "a point's number"
  const char* stage = "";   ///< for the progress
  /// Reads what follows the number of row `index` (from 0); `number` is the one it has in the file. Called once a row,
  /// from several threads; may throw Error{input} through the scanner.
  std::function<void(TextScanner& in, std::size_t index, std::int64_t number)> read;
  std::size_t stretch = 1 << 19;  ///< bytes that a thread reads at a time, at least
};

/// What came of a table.
struct RowsRead {
  std::int64_t firstNumber = 0;
  std::size_t longLines = 0;  ///< with more than was read
};

/// Reads the `rows` that follow in `in`, by several threads. Whatever is wrong is then found again line by line, so
/// that the message is that of the first wrong line. Throws Error{input}.
RowsRead readNumberedRows(TextScanner& in, const NumberedRows& rows, const Progress& progress);

}  // namespace havs
