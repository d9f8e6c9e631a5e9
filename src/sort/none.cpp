// No order: the faces as buildFaces numbered them. Shows what the k-buffer does alone, and costs nothing where the
// order does not matter.
#include <numeric>

#include "sort/sorters.h"

namespace havs {
namespace {

class FileOrderSorter final : public FaceSorter {
 public:
  explicit FileOrderSorter(const SortInput& input) : faceCount_(input.faces->size()) {}

  void sort(const ViewPoint&, FaceOrder& order) override {
    order.cycles = 0;
    order.faces.resize(faceCount_);
    std::iota(order.faces.begin(), order.faces.end(), Index{0});
  }

 private:
  std::size_t faceCount_;
};

}  // namespace

std::unique_ptr<FaceSorter> makeFileOrderSorter(const SortInput& input) {
  return std::make_unique<FileOrderSorter>(input);
}

}  // namespace havs
