#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <span>

#include "mesh/file_blocks.h"
#include "mesh/vtu/vtu_layout.h"

namespace havs {

/// The numbers of a DataArray, in whichever way the file holds them.
class VtuData {
 public:
  virtual ~VtuData() = default;
  /// Takes numbers first, first + 1, ... of the array, one after another in `bytes`, in the array's type. False when it
  /// does not like them.
  using Sink = std::function<bool(std::size_t first, std::span<const std::byte> bytes)>;
  /// Hands all numbers to `sink`, in pieces, from several threads. False when the file does not hold them or the sink
  /// refused a piece; some pieces may have come before.
  virtual bool visit(const Sink& sink) const = 0;
};

/// The data of `array`, opened: they announce themselves as `count` numbers, and the file is long enough to hold them,
/// so memory may be taken for them. Null when not.
std::unique_ptr<VtuData> openVtuData(const FileBlocks& file, const VtuLayout& layout, const VtuArray& array,
                                     std::size_t count);

}  // namespace havs
