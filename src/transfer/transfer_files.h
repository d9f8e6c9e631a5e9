#pragma once
// The readers behind loadTransferFunction: one a format, each from the file's bytes. `file` is what error messages
// name. All throw Error{input} for content that is broken or makes no sense, with its place.
#include <string>
#include <string_view>

#include "transfer/transfer_function.h"

namespace havs {

/// Our own JSON (docs/03-transfer-functions.md).
TransferFunction readTransferJson(std::string_view text, const std::string& file);

/// ParaView's colour maps: JSON (a list of maps, or one) and XML (<ColorMaps> or one <ColorMap>). Exactly one map is
/// expected.
TransferFunction readParaViewJson(std::string_view text, const std::string& file);
TransferFunction readParaViewXml(std::string_view text, const std::string& file);

/// True where a JSON text holds a colour map of ParaView's rather than a transfer function of ours. Throws Error{input}
/// where it is no JSON.
bool isParaViewJson(std::string_view text, const std::string& file);

/// TF.bin: kTableEntries entries of 4 little-endian floats (r, g, b, opacity per unit), at equal steps from scalar 0
/// to 1. Entries that lie on the line between their neighbours, within 1e-6 in every channel, are left out.
inline constexpr std::size_t kTableEntries = 65536;
inline constexpr std::size_t kTableBytes = kTableEntries * 4 * sizeof(float);
TransferFunction readTransferTable(std::string_view bytes, const std::string& file);

/// Throws Error{input} naming the point (counted from 1) unless scalars ascend (at most two at one), are finite and,
/// where normalised, in [0, 1]; colours lie in [0, 1]; opacities in [0, 1] (perUnit) or at least 0 (extinction); unit
/// length and domain make sense.
void checkTransferFunction(const TransferFunction& function, const std::string& where);

}  // namespace havs
