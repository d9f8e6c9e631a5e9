#pragma once
// Which boundary faces a stretch of a ray may meet: a tree of boxes, four to a box, over the faces in the order of a
// Morton curve. The tree says "may": it leaves out no face, the caller tests exactly.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "mesh/faces.h"

namespace havs {

class BoundaryTree {
 public:
  /// Parallel; the result does not depend on the number of threads.
  BoundaryTree(std::span<const Vec3> points, const Faces& faces);

  /// Calls visit(face) -> bool for each face whose box the straight line from `from` to `to` meets or nearly meets, in
  /// an order that depends on the tree only, until one returns false.
  template <class Visit>
  void visitNear(const Vec3& from, const Vec3& to, const Visit& visit) const;

  /// A distance within which every straight line that starts at `from` has left all faces behind.
  double reach(const Vec3& from) const;

 private:
  static constexpr std::size_t kWidth = 4;
  struct Box {
    Vec3 center, half;
  };
  static Box around(const Vec3& low, const Vec3& high);
  void addLevel();

  std::vector<Index> faces_;  ///< along the curve
  std::vector<std::vector<Box>>
      levels_;  ///< box i of a level holds boxes (level 0: faces) kWidth i ... of the one below
};

template <class Visit>
void BoundaryTree::visitNear(const Vec3& from, const Vec3& to, const Visit& visit) const {
  if (faces_.empty()) return;
  // A box and a stretch are apart if and only if they are along an axis of the box, or one across it and the stretch.
  const Vec3 middle = 0.5 * (from + to), half = 0.5 * (to - from), extent = abs(half);
  const auto meets = [&](const Box& box) {
    const Vec3 m = middle - box.center, a = abs(m), e = box.half;
    return a.x <= e.x + extent.x && a.y <= e.y + extent.y && a.z <= e.z + extent.z &&
           std::abs(m.y * half.z - m.z * half.y) <= e.y * extent.z + e.z * extent.y &&
           std::abs(m.z * half.x - m.x * half.z) <= e.z * extent.x + e.x * extent.z &&
           std::abs(m.x * half.y - m.y * half.x) <= e.x * extent.y + e.y * extent.x;
  };
  struct Entry {
    std::size_t level, box;
  };
  std::array<Entry, 64> stack;  // at most 3 a level beyond the first, of 16 levels
  std::size_t count = 0;
  const std::size_t top = levels_.size() - 1;
  if (meets(levels_[top][0])) stack[count++] = {top, 0};
  while (count > 0) {
    const auto [level, box] = stack[--count];
    const std::size_t first = box * kWidth;
    if (level == 0) {
      for (std::size_t i = first; i < std::min(first + kWidth, faces_.size()); ++i)
        if (!visit(faces_[i])) return;
      continue;
    }
    const std::vector<Box>& below = levels_[level - 1];
    for (std::size_t i = std::min(first + kWidth, below.size()); i-- > first;)
      if (meets(below[i])) stack[count++] = {level - 1, i};
  }
}

}  // namespace havs
