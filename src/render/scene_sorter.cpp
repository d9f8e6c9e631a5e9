#include "render/scene_sorter.h"

namespace havs {
namespace {

std::unique_ptr<FaceSorter> sorterOf(const PreparedScene& scene, const SortMethod& method) {
  return method.make({scene.points, scene.mesh.tetrahedra, &scene.faces});
}

/// The order of the whole mesh, without the faces that are not drawn.
class WholeOrderSorter final : public FaceSorter {
 public:
  WholeOrderSorter(const PreparedScene& part, const SortMethod& method)
      : sorter_(sorterOf(*part.whole, method)), numbers_(part.whole->faces.size(), kNoIndex) {
    for (std::size_t f = 0; f < part.facesInWhole.size(); ++f) numbers_[part.facesInWhole[f]] = static_cast<Index>(f);
  }

  void sort(const ViewPoint& view, FaceOrder& order) override {
    sorter_->sort(view, whole_);
    order.cycles = whole_.cycles;
    order.faces.clear();
    for (const Index face : whole_.faces)
      if (numbers_[face] != kNoIndex) order.faces.push_back(numbers_[face]);
  }

 private:
  std::unique_ptr<FaceSorter> sorter_;
  std::vector<Index> numbers_;  ///< in the part, of each face of the whole
  FaceOrder whole_;
};

/// The part's own order until it is found wanting.
class PartSorter final : public FaceSorter {
 public:
  PartSorter(const PreparedScene& part, const SortMethod& method)
      : part_(part), method_(method), sorter_(sorterOf(part, method)) {}

  void sort(const ViewPoint& view, FaceOrder& order) override { sorter_->sort(view, order); }
  void sortInPieces(const ViewPoint& view, FaceOrder& order, const std::function<void(std::size_t)>& ready) override {
    sorter_->sortInPieces(view, order, ready);
  }

  bool refine(const ViewPoint& view, FaceOrder& order) override {
    if (refined_) return false;
    refined_ = true;
    sorter_ = std::make_unique<WholeOrderSorter>(part_, method_);
    sorter_->sort(view, order);
    return true;
  }

 private:
  const PreparedScene& part_;
  const SortMethod& method_;
  std::unique_ptr<FaceSorter> sorter_;
  bool refined_ = false;
};

}  // namespace

std::unique_ptr<FaceSorter> makeSceneSorter(const PreparedScene& prepared, const std::string& sort, PartOrder order) {
  const SortMethod& method = sortMethod(sort);
  if (prepared.whole == nullptr || !method.usesNeighbours) return sorterOf(prepared, method);
  if (order == PartOrder::asInWhole) return std::make_unique<WholeOrderSorter>(prepared, method);
  return std::make_unique<PartSorter>(prepared, method);
}

}  // namespace havs
