// A .vtu file goes straight into the mesh: each array is decoded in pieces that fit the cache, and a piece is written
// to its place in the mesh's own numbers. So nothing is held twice, and every core decodes.
#include "mesh/vtu/vtu_reader.h"

#include <algorithm>
#include <cstring>

#include "core/memory_budget.h"
#include "mesh/vtu/number_types.h"
#include "mesh/vtu/vtu_data.h"
#include "mesh/vtu/vtu_layout.h"

namespace havs {
namespace {

/// The numbers of a piece one by one: take(index in the array, number) for each. False where take is.
template <class Take>
bool takeEach(NumberType type, std::size_t first, std::span<const std::byte> bytes, const Take& take) {
  return withNumberType(type, [&]<class Number>() {
    bool good = true;
    for (std::size_t i = 0; i * sizeof(Number) < bytes.size(); ++i) {
      Number number;
      std::memcpy(&number, bytes.data() + i * sizeof(Number), sizeof(Number));
      good &= take(first + i, number);
    }
    return good;
  });
}

constexpr int kTetra = 10;

class PlainVtu {
 public:
  PlainVtu(const FileBlocks& file, VtuLayout layout) : file_(file), layout_(std::move(layout)) {}

  std::optional<TetMesh> read() {
    if (layout_.points >= kNoIndex || layout_.cells >= kNoIndex) return {};
    if (!onlyTetrahedra() || !readCorners() || !readPoints()) return {};
    if (!readFields(layout_.pointData, layout_.points, mesh_.pointFields)) return {};
    if (!readFields(layout_.cellData, layout_.cells, mesh_.cellFields)) return {};
    mesh_.sourceCells = layout_.cells;
    return std::move(mesh_);
  }

 private:
  template <class Take>
  bool takeAll(const VtuArray& array, const VtuData& data, const Take& take) {
    return data.visit(
        [&](std::size_t first, std::span<const std::byte> bytes) { return takeEach(array.type, first, bytes, take); });
  }

  /// What the file packs may be a thousand times larger.
  template <class T>
  void need(std::size_t count, const std::string& what) const {
    needMemory(sizeof(T) * static_cast<double>(count), std::to_string(count) + " " + what, file_.name());
  }

  std::unique_ptr<VtuData> open(const VtuArray& array, std::size_t count) const {
    return openVtuData(file_, layout_, array, count);
  }

  bool onlyTetrahedra() {
    const auto types = open(layout_.types, layout_.cells), offsets = open(layout_.offsets, layout_.cells);
    return types && offsets && takeAll(layout_.types, *types, [](std::size_t, auto type) { return type == kTetra; }) &&
           takeAll(layout_.offsets, *offsets,
                   [](std::size_t i, auto end) { return static_cast<std::uint64_t>(end) == 4 * (i + 1); });
  }

  bool readCorners() {
    const auto data = open(layout_.connectivity, 4 * layout_.cells);
    if (!data) return false;
    need<Tetrahedron>(layout_.cells, "tetrahedra");
    mesh_.tetrahedra.resize(layout_.cells);
    Index* const corners = mesh_.tetrahedra.front().data();
    static_assert(sizeof(Tetrahedron) == 4 * sizeof(Index));
    return takeAll(layout_.connectivity, *data, [corners, points = layout_.points](std::size_t i, auto point) {
      corners[i] = static_cast<Index>(point);
      return static_cast<std::uint64_t>(point) < points;  // a negative one becomes a large one
    });
  }

  bool readPoints() {
    const auto data = open(layout_.coordinates, 3 * layout_.points);
    if (!data) return false;
    need<Vec3>(layout_.points, "points");
    mesh_.points.resize(layout_.points);
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    return readDoubles(layout_.coordinates, *data, &mesh_.points.front().x);
  }

  bool readFields(const std::vector<VtuArray>& arrays, std::size_t tuples, std::vector<Field>& fields) {
    for (const VtuArray& array : arrays) {
      const auto data = open(array, array.components * tuples);
      if (!data) return false;
      need<double>(array.components * tuples, "values of '" + array.name + "'");
      fields.push_back({array.name, static_cast<int>(array.components), {}});
      fields.back().values.resize(array.components * tuples);
      if (!readDoubles(array, *data, fields.back().values.data())) return false;
    }
    return true;
  }

  bool readDoubles(const VtuArray& array, const VtuData& data, double* values) {
    return takeAll(array, data, [values](std::size_t i, auto number) {
      values[i] = static_cast<double>(number);
      return true;
    });
  }

  const FileBlocks& file_;
  VtuLayout layout_;
  TetMesh mesh_;
};

}  // namespace

std::optional<TetMesh> readPlainVtu(const std::filesystem::path& file) {
  const FileBlocks blocks(file);
  auto layout = vtuLayout(blocks);
  if (!layout) return {};
  return PlainVtu(blocks, std::move(*layout)).read();
}

}  // namespace havs
