#pragma once
#include <cstddef>
#include <span>

namespace havs {

/// Decodes whole groups of four characters (RFC 4648) that are not padded: 3 bytes a group. `bytes` has room for
/// 3 * (text.size() / 4). False for a character that is none of the alphabet's, '=' included.
bool decodeBase64(std::span<const char> text, std::span<std::byte> bytes);

}  // namespace havs
