// Base64 by one table for each of a group's four characters: the three bytes are the entries joined by "or".
#include "mesh/vtu/base64.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace havs {
namespace {

constexpr std::uint32_t kBad = 0x80000000;
using Table = std::array<std::uint32_t, 256>;

/// The first decoded byte is the lowest, as a little-endian store writes it.
constexpr Table tableOf(int place) {
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  Table table{};
  table.fill(kBad);
  for (std::uint32_t i = 0; i < 64; ++i) {
    const std::uint32_t bits = i << (18 - 6 * place);
    table[static_cast<unsigned char>(kAlphabet[i])] = ((bits >> 16) & 0xff) | (bits & 0xff00) | ((bits & 0xff) << 16);
  }
  return table;
}

constexpr std::array<Table, 4> kTables{tableOf(0), tableOf(1), tableOf(2), tableOf(3)};

std::uint32_t groupOf(const char* text) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 4; ++i) bits |= kTables[i][static_cast<unsigned char>(text[i])];
  return bits;
}

}  // namespace

bool decodeBase64(std::span<const char> text, std::span<std::byte> bytes) {
  const std::size_t groups = text.size() / 4;
  std::uint32_t seen = 0;
  for (std::size_t g = 0; g < groups; ++g) {
    const std::uint32_t bits = groupOf(text.data() + 4 * g);
    seen |= bits;
    std::memcpy(bytes.data() + 3 * g, &bits, 3);
  }
  return (seen & kBad) == 0;
}

}  // namespace havs
