#include "mesh/text_scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <type_traits>

#include "core/error.h"

namespace havs {
namespace {

bool isSeparator(char c) { return c == ' ' || c == '\t' || c == ',' || c == '\r' || c == '\v' || c == '\f'; }
bool endsWord(char c) { return isSeparator(c) || c == '\n' || c == '#'; }

std::string contentsOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream ? static_cast<std::streamoff>(stream.tellg()) : -1;
  if (size < 0) failInput("cannot be read", file.string(), "check that it exists and its permissions");
  std::string text(static_cast<std::size_t>(size), '\0');
  stream.seekg(0);
  stream.read(text.data(), size);
  if (stream.gcount() != size) failInput("cannot be read to its end", file.string(), "check the disk and permissions");
  return text;
}

/// Enough of a word to show it.
std::string shown(std::string_view word) { return std::string(word.substr(0, 40)); }

/// from_chars, which knows no plus sign and gives no value for 1e-400 or 1e400.
template <class Number>
bool parse(std::string_view word, Number& value) {
  const std::string_view digits = word.substr(word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0);
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (stop != digits.data() + digits.size()) return false;
  if constexpr (std::is_floating_point_v<Number>) {
    if (error == std::errc::result_out_of_range) {
      value = std::strtod(std::string(digits).c_str(), nullptr);
      return true;
    }
  }
  return error == std::errc{};
}

}  // namespace

TextScanner::TextScanner(const std::filesystem::path& file)
    : file_(file.string()), text_(contentsOf(file)), at_(text_.data()), end_(text_.data() + text_.size()) {
  const std::string_view head = std::string_view(text_).substr(0, 4096);
  if (head.find('\0') != std::string_view::npos || (!head.empty() && head[0] == '\x07'))
    failInput("the file is binary, text is expected", file_, "write it as ASCII");
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

std::string_view TextScanner::word(std::string_view wanted) {
  if (!more()) fail(fmt::format("{} is missing on this line", wanted), "is the file cut short, or its header wrong?");
  const char* begin = at_;
  at_ = std::find_if(at_, end_, endsWord);
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

double TextScanner::real(std::string_view wanted) {
  const std::string_view text = word(wanted);
  double value = 0;
  if (!parse(text, value)) fail(fmt::format("'{}' is no number, {} is expected", shown(text), wanted), "correct it");
  return value;
}

std::int64_t TextScanner::integer(std::string_view wanted) {
  const std::string_view text = word(wanted);
  std::int64_t value = 0;
  if (parse(text, value)) return value;
  fail(fmt::format("'{}' is no whole number, {} is expected", shown(text), wanted), "correct it");
}

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
  const auto left = static_cast<std::size_t>(end_ - at_) + 1;  // the last line may lack its end
  if (static_cast<std::size_t>(value) > left / std::max<std::size_t>(bytesEach, 1))
    fail(fmt::format("{} {} are promised, but the rest of the file is too short for them", value, wanted),
         "is the file cut short, or its header wrong?");
  return static_cast<std::size_t>(value);
}

void TextScanner::fail(const std::string& what, const std::string& tryThis) const { failInput(what, place(), tryThis); }

std::string TextScanner::place() const { return fmt::format("{}:{}", file_, line_ + 1); }

void TextScanner::skipSeparators() {
  while (at_ < end_ && isSeparator(*at_)) ++at_;
}

}  // namespace havs
