#include "fuzz/mutate.h"

#include <array>
#include <string_view>

namespace havs::fuzz {
namespace {

using namespace std::string_view_literals;

constexpr std::array kNumbers{
    "0"sv,
    "-1"sv,
    "1"sv,
    "2147483648"sv,
    "4294967295"sv,
    "9223372036854775807"sv,
    "18446744073709551616"sv,
    "1e400"sv,
    "1e9"sv,
    "nan"sv,
    "-inf"sv,
    "1e-320"sv,
    "\xff\xff\xff\xff"sv,
    "\0\0\0\x80"sv,
    "\0"sv,
    "\xef\xbb\xbf"sv,
};

/// From 0 to most - 1; the small bias of the modulus does no harm.
std::size_t below(std::size_t most, Random& random) { return most == 0 ? 0 : random() % most; }

struct Piece {
  std::size_t begin, length;
};
Piece pieceOf(const std::string& text, Random& random) {
  const std::size_t begin = below(text.size() + 1, random);
  return {begin, below(std::min<std::size_t>(text.size() - begin, 64) + 1, random)};
}

/// The word of letters, digits, signs and dots at a place, so that a number goes as a whole.
Piece wordAt(const std::string& text, std::size_t at) {
  constexpr std::string_view kEnds = " \t\r\n,:;[]{}<>\"=/";
  const std::size_t before = at == 0 ? std::string::npos : text.find_last_of(kEnds, at - 1);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  const std::size_t end = std::min(text.find_first_of(kEnds, at), text.size());
  return {begin, end - begin};
}

void change(std::string& text, const std::vector<std::string>& inputs, Random& random) {
  const std::size_t at = below(text.size(), random);
  const Piece piece = pieceOf(text, random);
  const auto number = kNumbers[below(kNumbers.size(), random)];
  switch (below(8, random)) {
    case 0:
      if (!text.empty()) text[at] = static_cast<char>(text[at] ^ (1 << below(8, random)));
      break;
    case 1:
      if (!text.empty()) text[at] = static_cast<char>(below(256, random));
      break;
    case 2:
      text.insert(at, number);
      break;
    case 3: {
      const Piece word = wordAt(text, at);
      text.replace(word.begin, word.length, number);
      break;
    }
    case 4:
      text.erase(piece.begin, piece.length);
      break;
    case 5:
      text.insert(at, text.substr(piece.begin, piece.length));
      break;
    case 6: {
      const std::string& other = inputs[below(inputs.size(), random)];
      const Piece part = pieceOf(other, random);
      text.replace(piece.begin, piece.length, other, part.begin, part.length);
      break;
    }
    default:
      text.resize(at);
  }
}

}  // namespace

std::string mutated(const std::vector<std::string>& inputs, Random& random) {
  std::string text = inputs[below(inputs.size(), random)];
  for (std::size_t changes = 1 + below(4, random); changes > 0; --changes) change(text, inputs, random);
  return text;
}

}  // namespace havs::fuzz
