// The oracle of the centroid order: a comparison sort by the distance from the eye to each face's centroid, all in
// double and as the definition says, with none of the tricks of centroid.cpp.
#include <algorithm>
#include <numeric>

#include "sort/sorters.h"

namespace havs {
namespace {

class ExactSorter final : public FaceSorter {
 public:
  explicit ExactSorter(const SortInput& input) : input_(input) {}

  void sort(const ViewPoint& view, FaceOrder& order) override {
    const std::size_t faceCount = input_.faces->size();
    std::vector<double> distances(faceCount);
    for (std::size_t f = 0; f < faceCount; ++f) {
      const auto& [a, b, c] = input_.faces->vertices[f];
      const Vec3 centroid = (input_.points[a] + input_.points[b] + input_.points[c]) / 3.0;
      distances[f] = view.orthographic ? dot(centroid, view.direction) : length(centroid - view.eye);
    }
    order.cycles = 0;
    order.faces.resize(faceCount);
    std::iota(order.faces.begin(), order.faces.end(), Index{0});
    std::stable_sort(order.faces.begin(), order.faces.end(),
                     [&](Index f, Index g) { return distances[f] < distances[g]; });
  }

 private:
  SortInput input_;
};

}  // namespace

std::unique_ptr<FaceSorter> makeExactSorter(const SortInput& input) { return std::make_unique<ExactSorter>(input); }

}  // namespace havs
