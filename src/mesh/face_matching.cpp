// Faces with the same vertices are found in linear time. Every cell is hung into a list of its lowest vertex, for the
// three faces that have it, and into one of its second lowest, for the fourth: two links a cell, made by one atomic
// exchange each. The faces in the lists of one vertex, some twenty, then find each other in a small table hashed by
// their two other vertices. The order in the lists depends on the threads; who finds whom does not, as at most two
// faces have the same vertices. Where more do, the list's faces are sorted.
#include "mesh/face_matching.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <utility>

#include "core/parallel.h"

namespace havs {
namespace {

/// The vertices of a cell in ascending order.
struct Ascending {
  std::array<Index, 4> vertex;
  std::array<std::uint32_t, 4> place;  ///< in the cell
  std::uint32_t parity;                ///< of the permutation: 1 odd
};

/// By the rank of each vertex: without a branch, as the processor could not guess where it goes.
Ascending ascending(const Tetrahedron& cell) {
  const auto& [a, b, c, d] = cell;
  const unsigned ba = b < a, ca = c < a, da = d < a, cb = c < b, db = d < b, dc = d < c;
  const std::array<unsigned, 4> rank{ba + ca + da, 1 - ba + cb + db, 2 - ca - cb + dc, 3 - da - db - dc};
  Ascending result{{}, {}, ba ^ ca ^ da ^ cb ^ db ^ dc};
  for (std::uint32_t i = 0; i < 4; ++i) {
    result.vertex[rank[i]] = cell[i];
    result.place[rank[i]] = i;
  }
  return result;
}

/// The lists: links 2 * cell (three faces with the cell's lowest vertex) and 2 * cell + 1 (the fourth).
struct Lists {
  std::vector<Index> first;  ///< one a vertex
  std::vector<Index> next;   ///< one a link
};

Lists listByLowestVertex(const TetMesh& mesh) {
  Lists lists{std::vector<Index>(mesh.points.size(), kNoIndex), std::vector<Index>(2 * mesh.tetrahedra.size())};
  parallelFor(0, mesh.tetrahedra.size(), kGrain, [&](std::size_t c) {
    const Ascending cell = ascending(mesh.tetrahedra[c]);
    for (std::size_t i = 0; i < 2; ++i) {
      const auto link = static_cast<Index>(2 * c + i);
      lists.next[link] = std::atomic_ref(lists.first[cell.vertex[i]]).exchange(link, std::memory_order_relaxed);
    }
  });
  return lists;
}

/// A face of a cell in the list of its lowest vertex.
struct ListedFace {
  std::uint64_t others;  ///< the two higher vertices, the lower of them in the high half
  Index record;          ///< 4 * cell + the opposite vertex's place
  bool turned;           ///< the sense of the outward face against that of the ascending vertices
  bool hasMate;
};

/// Finds the mates among the faces of one vertex. One object a thread.
class ListMatcher {
 public:
  ListMatcher(const TetMesh& mesh, const Lists& lists, std::vector<std::array<Index, 4>>& mates)
      : mesh_(mesh), lists_(lists), mates_(mates) {}

  /// Whether no more than two faces have the same vertices, and those two lie on opposite sides.
  bool match(std::size_t vertex) {
    faces_.clear();
    for (Index link = lists_.first[vertex]; link != kNoIndex; link = lists_.next[link]) collect(link);
    if (matchPairs()) return true;
    for (const ListedFace& face : faces_) mateOf(face) = kNoIndex;
    matchInOrder();
    return false;
  }

 private:
  Index& mateOf(const ListedFace& face) { return mates_[face.record >> 2][face.record & 3u]; }

  void pair(const ListedFace& one, const ListedFace& other) {
    mateOf(one) = other.record;
    mateOf(other) = one.record;
  }

  void collect(Index link) {
    const Index c = link / 2;
    const Ascending cell = ascending(mesh_.tetrahedra[c]);
    const auto& v = cell.vertex;
    // Moving the i-th vertex to the front takes i exchanges, and an even permutation keeps the outward sense.
    const auto add = [&](std::uint32_t i, Index lower, Index higher) {
      faces_.push_back(
          {std::uint64_t{lower} << 32 | higher, 4 * c + cell.place[i], ((cell.parity ^ i) & 1u) != 0, false});
    };
    if (link % 2 != 0) return add(0, v[2], v[3]);
    add(1, v[2], v[3]);
    add(2, v[1], v[3]);
    add(3, v[1], v[2]);
  }

  bool matchPairs() {
    const std::size_t size = std::bit_ceil(2 * faces_.size() + 2);
    table_.assign(size, kNoIndex);
    const int shift = 64 - std::countr_zero(size);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      ListedFace& face = faces_[f];
      std::size_t slot = (face.others * 0x9E3779B97F4A7C15ull) >> shift;
      while (table_[slot] != kNoIndex && faces_[table_[slot]].others != face.others) slot = (slot + 1) & (size - 1);
      if (table_[slot] == kNoIndex) {
        table_[slot] = static_cast<Index>(f);
        continue;
      }
      ListedFace& other = faces_[table_[slot]];
      if (other.hasMate || other.turned == face.turned) return false;
      other.hasMate = true;
      pair(face, other);
    }
    return true;
  }

  void matchInOrder() {
    std::sort(faces_.begin(), faces_.end(), [](const ListedFace& x, const ListedFace& y) {
      if (x.others != y.others) return x.others < y.others;
      if (x.turned != y.turned) return y.turned;
      return x.record < y.record;
    });
    for (std::size_t first = 0; first < faces_.size();) {
      std::size_t turned = first;
      while (turned < faces_.size() && faces_[turned].others == faces_[first].others && !faces_[turned].turned)
        ++turned;
      std::size_t last = turned;
      while (last < faces_.size() && faces_[last].others == faces_[first].others) ++last;
      for (std::size_t one = first, other = turned; one < turned && other < last; ++one, ++other)
        pair(faces_[one], faces_[other]);
      first = last;
    }
  }

  const TetMesh& mesh_;
  const Lists& lists_;
  std::vector<std::array<Index, 4>>& mates_;
  std::vector<ListedFace> faces_;
  std::vector<Index> table_;  ///< of faces_, by hash of `others`
};

}  // namespace

FaceMates matchFaces(const TetMesh& mesh) {
  FaceMates mates;
  mates.of.assign(mesh.tetrahedra.size(), {kNoIndex, kNoIndex, kNoIndex, kNoIndex});
  const Lists lists = listByLowestVertex(mesh);
  std::atomic<bool> plain = true;
  parallelBlocks(0, mesh.points.size(), 256, [&](std::size_t first, std::size_t last) {
    ListMatcher matcher(mesh, lists, mates.of);
    bool mine = true;
    for (std::size_t vertex = first; vertex < last; ++vertex) mine = matcher.match(vertex) && mine;
    if (!mine) plain = false;
  });
  mates.plain = plain;
  return mates;
}

}  // namespace havs
