// A table read in stretches, cut anywhere and by any number of threads, is the table read line by line: the same rows,
// and for a wrong one the same message.
#include "mesh/numbered_rows.h"

#include <gmock/gmock.h>

#include <random>

#include "core/parallel.h"
#include "unit/mesh/mesh_checks.h"

namespace havs {
namespace {

struct Outcome {
  std::vector<double> values;
  std::int64_t firstNumber = 0;
  std::size_t longLines = 0;
  std::string error;
  bool operator==(const Outcome&) const = default;
};

/// One number a row, behind a header line.
Outcome readTable(const std::filesystem::path& file, std::size_t count, std::size_t stretch) {
  Outcome outcome;
  outcome.values.assign(count, -1);
  outcome.error = test::inputError([&] {
    TextScanner in(file);
    in.needLine("the header");
    const auto read = [&](TextScanner& line, std::size_t index, std::int64_t number) {
      outcome.values.at(index) = line.real("a value");
      if (outcome.values[index] != static_cast<double>(2 * number)) line.fail("not twice its number");
    };
    NumberedRows rows{count, stretch == 0, "row", "rows", "a row's number", "read rows", read};
    rows.stretch = stretch;
    const RowsRead result = readNumberedRows(in, rows, {});
    outcome.firstNumber = result.firstNumber;
    outcome.longLines = result.longLines;
  });
  if (!outcome.error.empty()) outcome.values.clear();  // rows behind the wrong one may have been read
  return outcome;
}

/// Rows with comments, blank lines, long lines and carriage returns between them.
std::vector<std::string> tableLines(std::size_t count, std::int64_t first) {
  std::mt19937 random(static_cast<unsigned>(count));
  std::vector<std::string> lines{"header"};
  const char* const ends[] = {"", " # note", "\r", " 7", "  ", ",", "\t#"};
  const char* const between[] = {"", "# 3 4 5", "  ", "\r"};
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t number = first + static_cast<std::int64_t>(i);
    lines.push_back(std::to_string(number) + (random() % 2 ? " " : "\t +") + std::to_string(2 * number) +
                    ends[random() % 7]);
    if (random() % 4 == 0) lines.push_back(between[random() % 4]);
  }
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

void expectSameInStretches(const std::filesystem::path& file, std::size_t count, const Outcome& expected) {
  for (const std::size_t threads : {1, 2, 5}) {
    const ThreadLimit limit(threads);
    for (const std::size_t stretch : {1, 2, 3, 5, 8, 13, 21, 34, 100, 1000, 100000})
      ASSERT_EQ(readTable(file, count, stretch), expected) << stretch << " bytes, " << threads << " threads";
  }
}

TEST(NumberedRows, StretchesGiveTheSameRows) {
  const test::TemporaryFolder folder;
  for (const std::size_t count : {1, 2, 7, 200}) {
    for (const std::int64_t first : {0, 1}) {
      const auto file = folder.write("table", joined(tableLines(count, first)));
      const Outcome expected = readTable(file, count, 0);
      ASSERT_EQ(expected.error, "");
      EXPECT_EQ(expected.firstNumber, first);
      for (std::size_t i = 0; i < count; ++i)
        ASSERT_EQ(expected.values[i], 2.0 * static_cast<double>(first + static_cast<std::int64_t>(i)));
      expectSameInStretches(file, count, expected);
    }
  }
}

TEST(NumberedRows, LinesBehindTheLastRowDoNotMatter) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("table", joined(tableLines(50, 1)));
  const Outcome expected = readTable(file, 30, 0);
  ASSERT_EQ(expected.error, "");
  expectSameInStretches(file, 30, expected);
}

TEST(NumberedRows, WrongRowsGiveTheSameMessageInStretches) {
  constexpr std::size_t kCount = 60;
  const std::vector<std::string> good = tableLines(kCount, 1);
  const auto isRow = [](const std::string& line) { return !line.empty() && line[0] >= '0' && line[0] <= '9'; };
  const char* const wrongs[] = {"7", "x 2", "1 2", "5 x", "99999999999999999999 1", "-3 4", "60 120", "61 122", ""};
  const test::TemporaryFolder folder;
  int failures = 0;
  for (std::size_t at = 1; at < good.size(); ++at) {
    if (!isRow(good[at])) continue;
    std::vector<std::string> lines = good;
    lines[at] = wrongs[at % std::size(wrongs)];
    const auto file = folder.write("table", joined(lines));
    const Outcome expected = readTable(file, kCount, 0);
    failures += expected.error.empty() ? 0 : 1;
    expectSameInStretches(file, kCount, expected);
    if (!expected.error.empty() && lines[at] != "") {
      EXPECT_THAT(expected.error, testing::HasSubstr("table:" + std::to_string(at + 1) + ":")) << lines[at];
    }
  }
  EXPECT_GT(failures, 50);  // of 60: all but those that only lengthen a line
}

TEST(NumberedRows, OfTwoWrongRowsTheFirstIsNamed) {
  std::vector<std::string> lines = tableLines(100, 1);
  const test::TemporaryFolder folder;
  lines[20] = "oops";
  lines[90] = "oops";
  const auto file = folder.write("table", joined(lines));
  const Outcome expected = readTable(file, 100, 0);
  EXPECT_THAT(expected.error, testing::HasSubstr("table:21:"));
  expectSameInStretches(file, 100, expected);
}

TEST(NumberedRows, ATextCutAnywhereGivesTheSameMessage) {
  const std::string text = joined(tableLines(12, 0));
  const test::TemporaryFolder folder;
  for (std::size_t length = 7; length < text.size(); ++length) {
    const auto file = folder.write("table", text.substr(0, length));
    const Outcome expected = readTable(file, 12, 0);
    for (const std::size_t stretch : {1, 4, 9, 16, 50}) ASSERT_EQ(readTable(file, 12, stretch), expected) << length;
  }
}

}  // namespace
}  // namespace havs
