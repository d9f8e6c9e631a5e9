#pragma once
#include "core/isolated.h"
#include "mesh/vtk/grid_blocks.h"
#include "mesh/vtk/vtk_module.h"

namespace havs {

/// Sends what the module finds to the parent process.
class GridWriter : public GridSink {
 public:
  explicit GridWriter(ByteWriter& out) : out_(out) {}
  void add(CellSoup&& cells) override;
  void add(StructuredBlock&& grid) override;
  void note(const std::string& text) override;
  std::size_t memoryLimit() const override;
  void fail(const std::string& what) override { failure_ = what; }
  /// After the last block. Throws Error{input} with `where` when the module failed.
  void finish(const std::string& where);

 private:
  ByteWriter& out_;
  std::string failure_;
};

/// Reads what a GridWriter sent.
GridBlocks receiveGrids(ByteReader& in);

}  // namespace havs
