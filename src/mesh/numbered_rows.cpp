// A table by several threads: its text is cut at ends of lines into stretches. As lines carry consecutive numbers, the
// first number of each stretch tells the places of its rows. A stretch that does not run up to the next one's first
// number, or has a wrong line, sends all back to reading line by line, which says what is wrong.
#include "mesh/numbered_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"

namespace havs {
namespace {

RowsRead readLineByLine(TextScanner& in, const NumberedRows& rows, const Progress& progress) {
  constexpr std::size_t kReport = 65536;
  RowsRead result;
  for (std::size_t i = 0; i < rows.count; ++i) {
    if (!in.nextLine())
      in.fail(fmt::format("the file ends after {} of {} {}", i, rows.count, rows.many),
              "is it cut short, or its header wrong?");
    const std::int64_t number = in.integer(rows.number);
    if (i == 0 && number != 0 && number != 1)
      in.fail(fmt::format("the first {}'s number is {}", rows.one, number), "start at 0 or at 1");
    if (i == 0) result.firstNumber = number;
    const std::int64_t wanted = result.firstNumber + static_cast<std::int64_t>(i);
    if (number != wanted)
      in.fail(fmt::format("{} number {} stands where {} is expected", rows.one, number, wanted),
              "number them one after the other, from 0 or from 1");
    rows.read(in, i, number);
    in.refuseDecimalCommas();
    result.longLines += in.more() ? 1 : 0;
    if (progress && i % kReport == 0) progress(rows.stage, in.fraction());
  }
  return result;
}

struct Stretch {
  std::string_view text;
  std::int64_t first = 0;  ///< number of its first row
  std::int64_t end = 0;    ///< of the first row of the next one
};

/// Stretches that hold rows, in order. Nothing when one begins with no number or they are out of order.
std::optional<std::vector<Stretch>> stretchesOf(const TextScanner& in, const NumberedRows& rows) {
  std::vector<Stretch> stretches;
  for (std::string_view rest = in.rest(); !rest.empty();) {
    const std::size_t cut = rest.find('\n', std::min(rows.stretch, rest.size()));
    const std::string_view text = rest.substr(0, cut == std::string_view::npos ? cut : cut + 1);
    rest.remove_prefix(text.size());
    TextScanner head(in, text);
    if (head.nextLine()) stretches.push_back({text, head.integer(rows.number)});
  }
  if (stretches.empty() || stretches[0].first < 0 || stretches[0].first > 1) return {};
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const bool last = i + 1 == stretches.size();
    stretches[i].end = last ? stretches[0].first + static_cast<std::int64_t>(rows.count) : stretches[i + 1].first;
    if (stretches[i].end <= stretches[i].first) return {};
  }
  return stretches;
}

/// Number of lines with more than was read; nothing when the rows are not those that should be there.
std::optional<std::size_t> readStretch(const TextScanner& whole, const Stretch& stretch, std::int64_t firstNumber,
                                       const NumberedRows& rows) {
  TextScanner in(whole, stretch.text);
  std::size_t longLines = 0;
  std::int64_t wanted = stretch.first;
  for (; in.nextLine(); ++wanted) {
    if (wanted == stretch.end || in.integer(rows.number) != wanted) return {};
    rows.read(in, static_cast<std::size_t>(wanted - firstNumber), wanted);
    in.refuseDecimalCommas();
    longLines += in.more() ? 1 : 0;
  }
  if (wanted != stretch.end) return {};
  return longLines;
}

std::optional<RowsRead> readInStretches(const TextScanner& in, const NumberedRows& rows, const Progress& progress) {
  const auto stretches = stretchesOf(in, rows);
  if (!stretches) return {};
  const std::int64_t firstNumber = stretches->front().first;
  std::atomic<std::size_t> longLines = 0;
  std::atomic<bool> good = true;
  std::mutex reporting;
  std::size_t done = 0;
  parallelFor(0, stretches->size(), 1, [&](std::size_t i) {
    if (!good) return;
    try {
      if (const auto more = readStretch(in, (*stretches)[i], firstNumber, rows))
        longLines += *more;
      else
        good = false;
    } catch (const Error&) {
      good = false;  // found again line by line
    }
    if (!progress) return;
    const std::lock_guard lock(reporting);
    progress(rows.stage, static_cast<double>(++done) / static_cast<double>(stretches->size()));
  });
  if (!good) return {};
  return RowsRead{firstNumber, longLines};
}

}  // namespace

RowsRead readNumberedRows(TextScanner& in, const NumberedRows& rows, const Progress& progress) {
  if (rows.inOrder) return readLineByLine(in, rows, progress);
  try {
    if (const auto result = readInStretches(in, rows, progress)) return *result;
  } catch (const Error&) {  // a stretch that begins with no number
  }
  return readLineByLine(in, rows, progress);
}

}  // namespace havs
