#pragma once
#include <memory>

#include "mesh/vtu/vtu_data.h"

namespace havs {

/// As openVtuData, for numbers as text.
std::unique_ptr<VtuData> openAsciiData(const FileBlocks& file, const VtuArray& array, std::size_t count);

}  // namespace havs
