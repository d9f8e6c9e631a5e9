// Unique faces in linear time: the four faces of every cell are binned by their lowest vertex (a counting sort), each
// small bin is sorted by the two other vertices, and equal neighbours in a bin are one face. A record is four bytes
// (4 * cell + the opposite vertex's place), so the bins cost 16 bytes a cell while they live.
#include "mesh/faces.h"

#include <algorithm>
#include <atomic>
#include <string>
#include <tuple>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"

namespace havs {
namespace {

constexpr std::size_t kGrain = 4096;

/// The vertices of the face opposite to vertex i of a right-handed cell, so that the normal points out of the cell.
constexpr std::array<std::array<int, 3>, 4> kOutwardFace{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

std::array<Index, 3> outwardFace(const Tetrahedron& cell, unsigned opposite) {
  const auto& corner = kOutwardFace[opposite];
  return {cell[static_cast<std::size_t>(corner[0])], cell[static_cast<std::size_t>(corner[1])],
          cell[static_cast<std::size_t>(corner[2])]};
}

Index lowestVertex(const Tetrahedron& cell, unsigned opposite) {
  const auto face = outwardFace(cell, opposite);
  return std::min({face[0], face[1], face[2]});
}

/// A face of one cell within the bin of its lowest vertex.
struct CellFace {
  std::uint64_t others;  ///< the two higher vertices, the lower of them in the high half
  std::uint32_t record;  ///< 4 * cell + opposite
  bool turned;           ///< the sense of the outward face against that of the ascending vertices
};

CellFace cellFace(const Tetrahedron& cell, std::uint32_t record) {
  auto [a, b, c] = outwardFace(cell, record & 3u);
  // Turn until the lowest vertex is first: this keeps the sense.
  if (b < a && b < c) {
    std::tie(a, b, c) = std::make_tuple(b, c, a);
  } else if (c < a && c < b) {
    std::tie(a, b, c) = std::make_tuple(c, a, b);
  }
  const bool turned = b > c;
  if (turned) std::swap(b, c);
  return {(std::uint64_t{b} << 32) | c, record, turned};
}

/// Records of all cell faces, binned by lowest vertex: bin v is records[begin[v] .. begin[v + 1]), in any order.
struct Bins {
  std::vector<std::uint32_t> begin;
  std::vector<std::uint32_t> records;
};

Bins binByLowestVertex(const TetMesh& mesh) {
  const auto& cells = mesh.tetrahedra;
  Bins bins;
  // Counts are kept one place ahead, so that filling the bins moves each count to the begin of the next bin.
  bins.begin.assign(mesh.points.size() + 2, 0);
  parallelFor(0, cells.size(), kGrain, [&](std::size_t c) {
    for (unsigned i = 0; i < 4; ++i)
      std::atomic_ref(bins.begin[lowestVertex(cells[c], i) + 2]).fetch_add(1, std::memory_order_relaxed);
  });
  for (std::size_t v = 2; v < bins.begin.size(); ++v) bins.begin[v] += bins.begin[v - 1];
  bins.records.resize(4 * cells.size());
  parallelFor(0, cells.size(), kGrain, [&](std::size_t c) {
    for (unsigned i = 0; i < 4; ++i) {
      const auto place =
          std::atomic_ref(bins.begin[lowestVertex(cells[c], i) + 1]).fetch_add(1, std::memory_order_relaxed);
      bins.records[place] = static_cast<std::uint32_t>(4 * c + i);
    }
  });
  bins.begin.pop_back();
  return bins;
}

constexpr Index kSecondCell = Index{1} << 31;  ///< mark of the cell face that is cells[1] of its face

/// Numbers the faces of one bin from 0 and writes the numbers to ofCell, with kSecondCell where it applies. Returns how
/// many there are. Cells on opposite sides of one triangle are paired in the order of their numbers; what stays alone
/// is a boundary face.
Index numberFacesOfBin(std::vector<CellFace>& bin, std::vector<std::array<Index, 4>>& ofCell) {
  std::sort(bin.begin(), bin.end(), [](const CellFace& x, const CellFace& y) {
    if (x.others != y.others) return x.others < y.others;
    if (x.turned != y.turned) return y.turned;
    return x.record < y.record;
  });
  auto numberOf = [&](const CellFace& f) -> Index& { return ofCell[f.record >> 2][f.record & 3u]; };
  Index count = 0;
  for (std::size_t first = 0; first < bin.size();) {
    std::size_t turned = first;
    while (turned < bin.size() && bin[turned].others == bin[first].others && !bin[turned].turned) ++turned;
    std::size_t last = turned;
    while (last < bin.size() && bin[last].others == bin[first].others) ++last;
    std::size_t one = first, other = turned;
    for (; one < turned && other < last; ++one, ++other) {
      const bool oneIsFirst = bin[one].record < bin[other].record;
      numberOf(bin[oneIsFirst ? one : other]) = count;
      numberOf(bin[oneIsFirst ? other : one]) = count++ | kSecondCell;
    }
    for (; one < turned; ++one) numberOf(bin[one]) = count++;
    for (; other < last; ++other) numberOf(bin[other]) = count++;
    first = last;
  }
  return count;
}

/// Numbers the faces within every bin; returns the number of the first face of each bin, and the number of all faces as
/// last entry.
std::vector<Index> numberFaces(const TetMesh& mesh, const Bins& bins, std::vector<std::array<Index, 4>>& ofCell) {
  const std::size_t binCount = mesh.points.size();
  std::vector<Index> firstFace(binCount + 1, 0);
  parallelBlocks(0, binCount, 256, [&](std::size_t begin, std::size_t end) {
    std::vector<CellFace> bin;
    for (std::size_t v = begin; v < end; ++v) {
      bin.clear();
      for (std::size_t r = bins.begin[v]; r < bins.begin[v + 1]; ++r)
        bin.push_back(cellFace(mesh.tetrahedra[bins.records[r] >> 2], bins.records[r]));
      firstFace[v + 1] = numberFacesOfBin(bin, ofCell);
    }
  });
  for (std::size_t v = 0; v < binCount; ++v) firstFace[v + 1] += firstFace[v];
  return firstFace;
}

}  // namespace

Faces buildFaces(const TetMesh& mesh) {
  const std::size_t cellCount = mesh.tetrahedra.size();
  if (cellCount >= kSecondCell / 4)
    failInput("a mesh of " + std::to_string(cellCount) + " tetrahedra has more faces than can be numbered", "",
              "use fewer than " + std::to_string(kSecondCell / 4));
  Faces faces;
  faces.ofCell.resize(cellCount);
  const std::vector<Index> firstFace = numberFaces(mesh, binByLowestVertex(mesh), faces.ofCell);
  const std::size_t faceCount = firstFace.back();
  faces.vertices.resize(faceCount);
  faces.cells.assign(faceCount, {kNoIndex, kNoIndex});
  parallelFor(0, cellCount, kGrain, [&](std::size_t c) {
    for (unsigned i = 0; i < 4; ++i) {
      Index& number = faces.ofCell[c][i];
      const bool second = (number & kSecondCell) != 0;
      number = firstFace[lowestVertex(mesh.tetrahedra[c], i)] + (number & ~kSecondCell);
      faces.cells[number][second ? 1 : 0] = static_cast<Index>(c);
      if (!second) faces.vertices[number] = outwardFace(mesh.tetrahedra[c], i);
    }
  });
  // Every inner face takes two of the cells' faces, every boundary face one.
  faces.boundaryCount = 2 * faceCount - 4 * cellCount;
  return faces;
}

}  // namespace havs
