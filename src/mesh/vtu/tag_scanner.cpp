#include "mesh/vtu/tag_scanner.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace havs {
namespace {

constexpr std::size_t kWindow = 1 << 18;
constexpr std::size_t kLongestTag = 1 << 16;
constexpr std::string_view kSpace = " \t\r\n";

std::string_view withoutSpace(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
  return text;
}

/// key="value" pairs; false when they are not of that form or hold an entity.
bool parseAttributes(std::string_view text, Tag& tag) {
  for (text = withoutSpace(text); !text.empty(); text = withoutSpace(text)) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) return false;
    std::string_view key = text.substr(0, equals);
    key = key.substr(0, key.find_last_not_of(kSpace) + 1);
    text = withoutSpace(text.substr(equals + 1));
    if (key.empty() || text.empty() || (text[0] != '"' && text[0] != '\'')) return false;
    const std::size_t quote = text.find(text[0], 1);
    if (quote == std::string_view::npos) return false;
    const std::string_view value = text.substr(1, quote - 1);
    if (value.find_first_of("&<") != std::string_view::npos) return false;
    if (!tag.attributes.emplace(key, value).second) return false;
    text.remove_prefix(quote + 1);
  }
  return true;
}

/// `text` is what stands between < and >.
bool parseTag(std::string_view text, Tag& tag) {
  if (text.ends_with('/')) {
    tag.empty = true;
    text.remove_suffix(1);
  }
  const std::size_t name = std::min(text.find_first_of(kSpace), text.size());
  tag.name = text.substr(0, name);
  return !tag.name.empty() && parseAttributes(text.substr(name), tag);
}

}  // namespace

std::string Tag::attribute(const std::string& key, const std::string& otherwise) const {
  const auto found = attributes.find(key);
  return found == attributes.end() ? otherwise : found->second;
}

std::optional<Tag> TagScanner::next() {
  while (true) {
    const auto begin = find('<', at_);
    if (!begin) return {};
    const char kind = at(*begin + 1);
    const bool comment = kind == '!' && at(*begin + 2) == '-' && at(*begin + 3) == '-';
    if (kind == '!' && !comment) return {};
    auto end = comment ? find('>', *begin) : endOfTag(*begin);
    while (comment && end && !(*end >= *begin + 6 && at(*end - 1) == '-' && at(*end - 2) == '-'))
      end = find('>', *end + 1);
    if (!end) return {};
    at_ = *end + 1;
    if (comment || kind == '?') continue;
    std::string text(*end - *begin - 1, '\0');
    Tag tag;
    tag.begin = *begin;
    tag.end = at_;
    if (!file_.read(*begin + 1, text) || !parseTag(text, tag)) return {};
    return tag;
  }
}

char TagScanner::at(std::size_t place) { return fill(place) ? window_[place - windowBegin_] : '\0'; }

/// Makes `place` part of the window; false behind the end of the file.
bool TagScanner::fill(std::size_t place) {
  if (place >= windowBegin_ && place < windowBegin_ + window_.size()) return true;
  if (place >= file_.size()) return false;
  constexpr std::size_t kBefore = 8;  // a comment's end is looked at backwards
  windowBegin_ = place - std::min(place, kBefore);
  window_.resize(std::min(kWindow, file_.size() - windowBegin_));
  if (file_.read(windowBegin_, window_)) return true;
  window_.clear();
  return false;
}

std::optional<std::size_t> TagScanner::find(char wanted, std::size_t from) {
  while (fill(from)) {
    const char* begin = window_.data() + (from - windowBegin_);
    const std::size_t length = window_.size() - (from - windowBegin_);
    if (const void* found = std::memchr(begin, wanted, length))
      return from + static_cast<std::size_t>(static_cast<const char*>(found) - begin);
    from += length;
  }
  return {};
}

/// The place of the > that ends the tag; one between quotes does not.
std::optional<std::size_t> TagScanner::endOfTag(std::size_t from) {
  char quote = '\0';
  for (std::size_t place = from + 1; place < from + kLongestTag; ++place) {
    const char c = at(place);
    if (c == '\0') return {};
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return place;
    }
  }
  return {};
}

}  // namespace havs
