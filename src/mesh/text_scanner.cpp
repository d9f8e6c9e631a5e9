#include "mesh/text_scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include "core/error.h"
#include "mesh/number_text.h"

namespace havs {
namespace {

enum CharacterKind : std::uint8_t { kPartOfWord, kSeparator, kEndOfLine };

constexpr std::array<CharacterKind, 256> kKinds = [] {
  std::array<CharacterKind, 256> kinds{};
  for (const char c : std::string_view(" \t,\r\v\f")) kinds[static_cast<unsigned char>(c)] = kSeparator;
  for (const char c : std::string_view("\n#")) kinds[static_cast<unsigned char>(c)] = kEndOfLine;
  return kinds;
}();

bool isSeparator(char c) { return kKinds[static_cast<unsigned char>(c)] == kSeparator; }
bool endsWord(char c) { return kKinds[static_cast<unsigned char>(c)] != kPartOfWord; }
/// from_chars for whole numbers of up to 18 digits, which cannot overflow: it stops before a 19th,
/// and what stops inside a word is another kind of word. Null where there is no digit.
const char* quickNumber(const char* at, const char* end, std::int64_t& value) {
  constexpr std::ptrdiff_t kMostDigits = 18;
  const bool negative = at != end && *at == '-';
  const char* const digits = at + (negative ? 1 : 0);
  std::int64_t sum = 0;
  for (at = digits; at != end && *at >= '0' && *at <= '9' && at - digits < kMostDigits; ++at)
    sum = 10 * sum + (*at - '0');
  if (at == digits) return nullptr;
  value = negative ? -sum : sum;
  return at;
}

const char* quickNumber(const char* at, const char* end, double& value) {
  const auto [stop, error] = std::from_chars(at, end, value);
  return error == std::errc{} ? stop : nullptr;
}

/// Enough of a word to show it.
std::string shown(std::string_view word) { return std::string(word.substr(0, 40)); }

}  // namespace

TextScanner::TextScanner(const std::filesystem::path& file)
    : file_(file.string()), text_(std::make_shared<FileText>(file)) {
  begin_ = at_ = text_->view().data();
  end_ = at_ + text_->view().size();
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text_->view().starts_with(kByteOrderMark)) at_ += kByteOrderMark.size();
  const std::string_view head = text_->view().substr(0, 4096);
  if (head.find('\0') != std::string_view::npos || (!head.empty() && head[0] == '\x07'))
    failInput("the file is binary, text is expected", file_, "write it as ASCII");
}

TextScanner::TextScanner(const TextScanner& whole, std::string_view lines)
    : file_(whole.file_),
      text_(whole.text_),
      begin_(lines.data()),
      at_(lines.data()),
      end_(lines.data() + lines.size()) {}

inline void TextScanner::skipSeparators() {
  while (at_ < end_ && isSeparator(*at_)) ++at_;
}

bool TextScanner::nextLine() {
  while (at_ < end_) {
    if (inLine_ || *at_ == '#') at_ = std::find(at_, end_, '\n');
    inLine_ = false;
    if (at_ == end_) break;
    if (*at_ == '\n') {
      ++at_;
      ++line_;
    }
    skipSeparators();
    if (at_ < end_ && *at_ != '\n' && *at_ != '#') {
      inLine_ = true;
      lineBegin_ = at_;
      return true;
    }
  }
  return false;
}

void TextScanner::needLine(std::string_view wanted) {
  if (!nextLine()) fail(fmt::format("the file ends here, but {} should follow", wanted), "is it cut short?");
}

bool TextScanner::more() {
  skipSeparators();
  return inLine_ && at_ < end_ && *at_ != '\n' && *at_ != '#';
}

void TextScanner::refuseDecimalCommas() {
  if (!more()) return;
  const std::string_view line(lineBegin_, static_cast<std::size_t>(std::find(at_, end_, '\n') - lineBegin_));
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t within = 0, others = 0;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const bool blank = line[i] == ' ' || line[i] == '\t';
    within += line[i] == ',' && isDigit(line[i - 1]) && isDigit(line[i + 1]) ? 1 : 0;
    others += blank && isDigit(line[i - 1]) && line[i + 1] != ',' ? 1 : 0;
  }
  if (within > 0 && others > 0)
    fail("the line holds more than its numbers, some of them joined by commas", "write decimal points: 0.5, not 0,5");
}

std::string_view TextScanner::word(std::string_view wanted) {
  if (!more()) fail(fmt::format("{} is missing on this line", wanted), "is the file cut short, or its header wrong?");
  const char* begin = at_;
  at_ = std::find_if(at_, end_, endsWord);
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

/// A plain number and the end of its word; what is none is left to the words' own way, which knows what to say.
template <class Number>
bool TextScanner::quickly(Number& value) {
  skipSeparators();
  const char* const stop = quickNumber(at_, end_, value);
  if (!inLine_ || !stop || (stop != end_ && !endsWord(*stop))) return false;
  at_ = stop;
  return true;
}

double TextScanner::real(std::string_view wanted) {
  double value = 0;
  if (quickly(value)) return value;
  const std::string_view text = word(wanted);
  if (!parseNumber(text, value))
    fail(fmt::format("'{}' is no number, {} is expected", shown(text), wanted), "correct it");
  return value;
}

std::int64_t TextScanner::integer(std::string_view wanted) {
  std::int64_t value = 0;
  if (quickly(value)) return value;
  const std::string_view text = word(wanted);
  if (parseNumber(text, value)) return value;
  fail(fmt::format("'{}' is no whole number, {} is expected", shown(text), wanted), "correct it");
}

char TextScanner::peek() { return more() ? *at_ : '\0'; }

std::string_view TextScanner::wholeLine(std::string_view wanted) {
  at_ = std::find(at_, end_, '\n');
  if (end_ - at_ < 2) needLine(wanted);  // which fails
  const char* begin = at_ + 1;
  ++line_;
  inLine_ = true;
  at_ = std::find(begin, end_, '\n');
  const char* stop = at_;
  while (begin < stop && std::isspace(static_cast<unsigned char>(*begin))) ++begin;
  while (stop > begin && std::isspace(static_cast<unsigned char>(stop[-1]))) --stop;
  return {begin, static_cast<std::size_t>(stop - begin)};
}

std::size_t TextScanner::count(std::string_view wanted, std::size_t bytesEach) {
  const std::int64_t value = integer(fmt::format("the number of {}", wanted));
  if (value < 0) fail(fmt::format("the number of {} is {}", wanted, value), "it must not be negative");
  const auto count = static_cast<std::size_t>(value);
  if (count > text_->view().size() || !holds(count * bytesEach))
    fail(fmt::format("{} {} are promised, but the rest of the file is too short for them", value, wanted),
         "is the file cut short, or its header wrong?");
  return count;
}

bool TextScanner::holds(std::size_t bytes) const {
  return bytes <= static_cast<std::size_t>(end_ - at_) + 1;  // the last line may lack its end
}

double TextScanner::fraction() const {
  return static_cast<double>(at_ - begin_) / static_cast<double>(std::max<std::ptrdiff_t>(end_ - begin_, 1));
}

std::string_view TextScanner::rest() const {
  const char* const begin = inLine_ ? std::find(at_, end_, '\n') : at_;
  return {begin, static_cast<std::size_t>(end_ - begin)};
}

void TextScanner::fail(const std::string& what, const std::string& tryThis) const { failInput(what, place(), tryThis); }

std::string TextScanner::place() const { return fmt::format("{}:{}", file_, line_ + 1); }

}  // namespace havs
