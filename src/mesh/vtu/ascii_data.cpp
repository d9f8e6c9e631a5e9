// Numbers as text, by several threads: the text is cut into stretches of one length, a word belongs to the stretch it
// begins in. First the words of each stretch are counted, which gives the number of its first one; then they are read.
#include "mesh/vtu/ascii_data.h"

#include <algorithm>
#include <atomic>
#include <vector>

#include "core/parallel.h"
#include "mesh/number_text.h"
#include "mesh/vtu/number_types.h"

namespace havs {
namespace {

constexpr std::size_t kStretch = 1 << 18;
constexpr std::size_t kLongestWord = 1 << 10;

bool isSpace(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }

class AsciiData : public VtuData {
 public:
  AsciiData(const FileBlocks& file, const VtuArray& array, std::size_t count)
      : file_(file), array_(array), count_(count) {}

  /// Counts the words; false when they are not as many as they should be.
  bool open() {
    firstWord_.assign(stretches() + 1, 0);
    std::atomic<bool> good = true;
    parallelFor(0, stretches(), 1, [&](std::size_t i) {
      if (const auto words = countWords(i))
        firstWord_[i + 1] = *words;
      else
        good = false;
    });
    for (std::size_t i = 0; i < stretches(); ++i) firstWord_[i + 1] += firstWord_[i];
    return good && firstWord_.back() == count_;
  }

  bool visit(const Sink& sink) const override {
    return withNumberType(array_.type, [&]<class Number>() { return visitAs<Number>(sink); });
  }

 private:
  std::size_t stretches() const { return (array_.end - array_.begin + kStretch - 1) / kStretch; }

  /// The text of a stretch, with the character before it and as much behind it as its last word may need. Nothing when
  /// the file cannot be read.
  std::optional<std::string_view> textOf(std::size_t stretch) const {
    thread_local std::vector<char> text;
    const std::size_t begin = array_.begin + stretch * kStretch - 1;  // the > of the tag, for the first
    text.resize(std::min(begin + 1 + kStretch + kLongestWord, array_.end) - begin);
    if (!file_.read(begin, text)) return {};
    if (stretch == 0) text[0] = ' ';
    if (begin + text.size() == array_.end) text.push_back(' ');  // so a word without a space behind it is cut off
    return std::string_view(text.data(), text.size());
  }

  std::optional<std::size_t> countWords(std::size_t stretch) const {
    const auto text = textOf(stretch);
    if (!text) return {};
    const std::size_t end = std::min(kStretch + 1, text->size());
    std::size_t words = 0;
    for (std::size_t i = 1; i < end; ++i) words += isSpace((*text)[i - 1]) && !isSpace((*text)[i]) ? 1 : 0;
    return words;
  }

  template <class Number>
  bool visitAs(const Sink& sink) const {
    std::atomic<bool> good = true;
    parallelFor(0, stretches(), 1, [&](std::size_t i) {
      thread_local std::vector<Number> numbers;
      numbers.resize(firstWord_[i + 1] - firstWord_[i]);
      if (!readWords<Number>(i, numbers) || !sink(firstWord_[i], std::as_bytes(std::span(numbers)))) good = false;
    });
    return good;
  }

  template <class Number>
  bool readWords(std::size_t stretch, std::span<Number> numbers) const {
    const auto text = textOf(stretch);
    if (!text) return false;
    const char* at = text->data();
    const char* const end = at + text->size();
    if (!isSpace(*at)) at = std::find_if(at, end, isSpace);  // a word of the stretch before
    for (Number& number : numbers) {
      at = std::find_if_not(at, end, isSpace);
      const auto [stop, error] = std::from_chars(at, end, number);
      const char* const wordEnd = error == std::errc{} && stop != end && isSpace(*stop) ? stop : nullptr;
      if (!wordEnd && !readSlowly(at, end, number)) return false;
      at = wordEnd ? wordEnd : std::find_if(at, end, isSpace);
    }
    return true;
  }

  /// A word with a plus sign, or out of range, or none.
  template <class Number>
  static bool readSlowly(const char* at, const char* end, Number& number) {
    const char* const wordEnd = std::find_if(at, end, isSpace);
    return wordEnd != end && parseNumber(std::string_view(at, wordEnd), number);
  }

  const FileBlocks& file_;
  VtuArray array_;
  std::size_t count_;
  std::vector<std::size_t> firstWord_;  ///< of each stretch, and the number of words
};

}  // namespace

std::unique_ptr<VtuData> openAsciiData(const FileBlocks& file, const VtuArray& array, std::size_t count) {
  if (count > (array.end - array.begin + 1) / 2) return {};
  auto data = std::make_unique<AsciiData>(file, array, count);
  if (!data->open()) return {};
  return data;
}

}  // namespace havs
