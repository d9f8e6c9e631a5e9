// Welding of identical points: sort the points by a hash of what they hold, then compare only within runs of one hash.
#include "mesh/weld.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>

#include "core/parallel.h"
#include "mesh/defects.h"

namespace havs {
namespace {

/// The bits of a coordinate or value, the same for -0 and 0.
std::uint64_t bitsOf(double value) { return std::bit_cast<std::uint64_t>(value == 0 ? 0.0 : value); }

std::uint64_t mix(std::uint64_t hash, std::uint64_t bits) {
  hash = (hash ^ bits) * 0x9E3779B97F4A7C15ull;
  return hash ^ (hash >> 29);
}

std::uint64_t hashOf(const std::vector<Vec3>& points, const std::vector<Field>& fields, std::size_t point) {
  std::uint64_t hash = 0x243F6A8885A308D3ull;
  for (int axis = 0; axis < 3; ++axis) hash = mix(hash, bitsOf(points[point][axis]));
  for (const Field& field : fields) {
    const auto n = static_cast<std::size_t>(field.components);
    for (std::size_t c = 0; c < n; ++c) hash = mix(hash, bitsOf(field.values[point * n + c]));
  }
  return hash;
}

bool sameTuple(const Field& field, Index a, Index b) {
  const auto n = static_cast<std::size_t>(field.components);
  for (std::size_t c = 0; c < n; ++c)
    if (bitsOf(field.values[a * n + c]) != bitsOf(field.values[b * n + c])) return false;
  return true;
}

bool samePoint(const std::vector<Vec3>& points, const std::vector<Field>& fields, Index a, Index b) {
  for (int axis = 0; axis < 3; ++axis)
    if (bitsOf(points[a][axis]) != bitsOf(points[b][axis])) return false;
  return std::all_of(fields.begin(), fields.end(), [&](const Field& field) { return sameTuple(field, a, b); });
}

}  // namespace

void keepTuples(const std::vector<char>& keep, Field& field) {
  const auto n = static_cast<std::size_t>(field.components);
  std::size_t to = 0;
  for (std::size_t from = 0; from < keep.size(); ++from) {
    if (!keep[from]) continue;
    std::copy_n(field.values.begin() + static_cast<std::ptrdiff_t>(from * n), n,
                field.values.begin() + static_cast<std::ptrdiff_t>(to * n));
    ++to;
  }
  field.values.resize(to * n);
}

std::vector<Index> keepPoints(const std::vector<char>& keep, std::vector<Vec3>& points,
                              std::vector<Field>& pointFields) {
  std::vector<Index> newNumber(points.size(), kNoIndex);
  Index next = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!keep[i]) continue;
    points[next] = points[i];
    newNumber[i] = next++;
  }
  points.resize(next);
  for (Field& field : pointFields) keepTuples(keep, field);
  return newNumber;
}

std::vector<Index> mergeIdenticalPoints(std::vector<Vec3>& points, std::vector<Field>& pointFields) {
  struct Entry {
    std::uint64_t hash;
    Index point;
    bool operator<(const Entry& other) const { return hash != other.hash ? hash < other.hash : point < other.point; }
  };
  std::vector<Entry> entries(points.size());
  parallelFor(0, points.size(), 4096, [&](std::size_t i) {
    entries[i] = {hashOf(points, pointFields, i), static_cast<Index>(i)};
  });
  tbb::parallel_sort(entries.begin(), entries.end());

  std::vector<Index> first(points.size());  // the first point that is the same as this one
  std::vector<char> keep(points.size(), 1);
  std::size_t merged = 0;
  for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
    while (end < entries.size() && entries[end].hash == entries[begin].hash) ++end;
    std::vector<Index> distinct;  // of this hash: one, unless hashes collide
    for (std::size_t i = begin; i < end; ++i) {
      const Index point = entries[i].point;
      const auto same =
          end - begin == 1 ? distinct.end() : std::find_if(distinct.begin(), distinct.end(), [&](Index other) {
            return samePoint(points, pointFields, other, point);
          });
      first[point] = same == distinct.end() ? point : *same;
      if (same != distinct.end()) {
        keep[point] = 0;
        ++merged;
      } else if (end - begin > 1) {
        distinct.push_back(point);
      }
    }
  }
  if (merged == 0) return {};
  const std::vector<Index> newNumber = keepPoints(keep, points, pointFields);
  for (Index& point : first) point = newNumber[point];
  return first;
}

std::size_t weldPoints(TetMesh& mesh) {
  const std::size_t before = mesh.points.size();
  const std::vector<Index> newNumber = mergeIdenticalPoints(mesh.points, mesh.pointFields);
  if (newNumber.empty()) return 0;
  parallelFor(0, mesh.tetrahedra.size(), 4096, [&](std::size_t i) {
    for (Index& point : mesh.tetrahedra[i]) point = newNumber[point];
  });
  return before - mesh.points.size();
}

}  // namespace havs
