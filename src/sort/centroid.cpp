// The paper's order (Callahan, Ikits, Comba, Silva 2005, section 3.1): faces by the distance of their centroids to the
// eye, as float keys that a radix sort takes in linear time. Approximate: a face whose centroid is nearer may well lie
// behind; the k-buffer mends what it can.
#include "core/parallel.h"
#include "mesh/radix_sort.h"
#include "sort/distance_key.h"
#include "sort/sorters.h"

namespace havs {
namespace {

class CentroidSorter final : public FaceSorter {
 public:
  explicit CentroidSorter(const SortInput& input) : input_(input) {}

  void sort(const ViewPoint& view, FaceOrder& order) override {
    const DistanceKey key(view);
    const auto& vertices = input_.faces->vertices;
    items_.resize(vertices.size());
    parallelFor(0, vertices.size(), 8192, [&](std::size_t f) {
      const auto& [a, b, c] = vertices[f];
      const Vec3 centroid = (input_.points[a] + input_.points[b] + input_.points[c]) / 3.0;
      items_[f] = {sortableKey(static_cast<float>(key(centroid))), static_cast<Index>(f)};
    });
    radixSorter_.sort(items_, order.faces);
    order.cycles = 0;
  }

 private:
  SortInput input_;
  std::vector<KeyedIndex> items_;
  RadixSorter radixSorter_;
};

}  // namespace

std::unique_ptr<FaceSorter> makeCentroidSorter(const SortInput& input) {
  return std::make_unique<CentroidSorter>(input);
}

}  // namespace havs
